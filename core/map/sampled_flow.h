#pragma once

#include <memory>

#include "core/integrate/flow.h"
#include "core/map/map.h"
#include "core/map/system.h"

namespace celt {

/// The map x → φ_τ(x) that advances a flow by a fixed time τ > 0: any flow, as a map. Its Jacobian
/// is the flow's tangent map; Image::time is τ. Its exponents per iterate are τ times those of the
/// flow, one of which is zero.
class SampledFlow final : public Map {
 public:
  SampledFlow(std::unique_ptr<Flow> flow, double time, const Numerics& numerics)
      : flow_(std::move(flow)), time_(time), numerics_(numerics) {}

  int dimension() const override { return flow_->dimension(); }
  absl::StatusOr<Image> Apply(const Point& x, Direction direction,
                              Derivative derivative) const override;

 private:
  std::unique_ptr<Flow> flow_;
  double time_;
  Numerics numerics_;
};

}  // namespace celt
