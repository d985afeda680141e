#pragma once

#include <span>

#include "core/integrate/crossing.h"
#include "core/integrate/ode_stepper.h"
#include "core/model/celtic_stone.h"

namespace celt {

/// The stone's equations as an initial value problem: M and γ, then, with derivatives, three
/// tangent vectors one after the other. The error of a step is measured, in root mean square over
/// all components, in units of `tolerance` times: |M| for M, 1 for γ, and for a tangent vector (δM,
/// δγ) the larger of |δM|/|M| and |δγ|, times the same. Tangents thus take part in the error test,
/// and the Jacobian is as good as the map.
class StoneProblem final : public OdeProblem {
 public:
  StoneProblem(const CelticStone& stone, Derivative derivative, double tolerance);

  int size() const override { return derivative_ == Derivative::kNone ? 6 : 24; }
  bool Rate(std::span<const double> y, std::span<double> rate) const override;
  void Weights(std::span<const double> y, std::span<double> weights) const override;

 private:
  CelticStone stone_;
  Derivative derivative_;
  double tolerance_;
};

/// Views of such a vector. Precondition for the second: it carries tangents.
Eigen::Map<const StoneState> StateOf(std::span<const double> y);
Eigen::Map<const StoneTangents> TangentsOf(std::span<const double> y);

}  // namespace celt
