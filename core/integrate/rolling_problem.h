#pragma once

#include <span>
#include <vector>

#include "core/integrate/ode_stepper.h"
#include "core/model/rolling.h"

namespace celt {

/// The stone's motion with its track (core/model/rolling.h) as an initial value problem. The error
/// of a step is measured, in root mean square over all components, in units of `tolerance` times:
/// |M| for M, 1 for γ, the heading and the spin [rad], the larger radius of curvature for the
/// contact point.
class RollingProblem final : public OdeProblem {
 public:
  RollingProblem(const CelticStone& stone, double tolerance)
      : stone_(stone), tolerance_(tolerance) {}

  int size() const override { return kRollingSize; }
  bool Rate(std::span<const double> y, std::span<double> rate) const override;
  void Weights(std::span<const double> y, std::span<double> weights) const override;

 private:
  CelticStone stone_;
  double tolerance_;
};

/// To and from the integrator's vector. Precondition of the second: kRollingSize entries.
std::vector<double> Pack(const RollingState& state);
RollingState UnpackRolling(std::span<const double> y);

}  // namespace celt
