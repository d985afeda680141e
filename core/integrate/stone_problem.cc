#include "core/integrate/stone_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace celt {

Eigen::Map<const StoneState> StateOf(std::span<const double> y) {
  return Eigen::Map<const StoneState>(y.data());
}

Eigen::Map<const StoneTangents> TangentsOf(std::span<const double> y) {
  return Eigen::Map<const StoneTangents>(y.data() + StoneState::SizeAtCompileTime);
}

StoneProblem::StoneProblem(const CelticStone& stone, Derivative derivative, double tolerance)
    : stone_(stone), derivative_(derivative), tolerance_(tolerance) {}

bool StoneProblem::Rate(std::span<const double> y, std::span<double> rate) const {
  const StoneState state = StateOf(y);
  // Trial stages may look a little beyond the domain; written so as to refuse NaN too.
  if (!(std::abs(state[5]) >= 0.5 * kLeastGamma3)) return false;
  Eigen::Map<StoneState>(rate.data()) = stone_.Field(state);
  if (derivative_ == Derivative::kJacobian) {
    Eigen::Map<StoneTangents>(rate.data() + state.size()).noalias() =
        stone_.FieldJacobian(state).lazyProduct(TangentsOf(y));
  }
  return true;
}

void StoneProblem::Weights(std::span<const double> y, std::span<double> weights) const {
  constexpr double kLeast =
      std::numeric_limits<double>::min();  // keeps the weight of a zero vector finite
  const double momentum = std::max(StateOf(y).head<3>().norm(), kLeast);
  for (std::size_t first = 0; first < y.size(); first += 6) {
    const Eigen::Map<const StoneState> vector(y.data() + first);
    const double size =
        first == 0 ? 1 : std::max(vector.head<3>().norm() / momentum, vector.tail<3>().norm());
    const double allowed = std::max(tolerance_ * size, kLeast);
    std::fill_n(weights.data() + first, 3, 1 / (allowed * momentum));
    std::fill_n(weights.data() + first + 3, 3, 1 / allowed);
  }
}

}  // namespace celt
