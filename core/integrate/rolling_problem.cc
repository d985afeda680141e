#include "core/integrate/rolling_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace celt {
namespace {

constexpr int kHeading = 6;
constexpr int kContact = 9;
constexpr int kSpin = 11;

void Write(const RollingState& state, std::span<double> y) {
  Eigen::Map<StoneState>(y.data()) = state.stone;
  Eigen::Map<Eigen::Vector3d>(y.data() + kHeading) = state.heading;
  Eigen::Map<Eigen::Vector2d>(y.data() + kContact) = state.contact;
  y[kSpin] = state.spin;
}

}  // namespace

std::vector<double> Pack(const RollingState& state) {
  std::vector<double> y(kRollingSize);
  Write(state, y);
  return y;
}

RollingState UnpackRolling(std::span<const double> y) {
  return {.stone = Eigen::Map<const StoneState>(y.data()),
          .heading = Eigen::Map<const Eigen::Vector3d>(y.data() + kHeading),
          .contact = Eigen::Map<const Eigen::Vector2d>(y.data() + kContact),
          .spin = y[kSpin]};
}

bool RollingProblem::Rate(std::span<const double> y, std::span<double> rate) const {
  const RollingState state = UnpackRolling(y);
  if (!(std::abs(state.stone[5]) >= kLeastGamma3)) return false;  // also for NaN
  Write(RollingRate(stone_, state), rate);
  return true;
}

void RollingProblem::Weights(std::span<const double> y, std::span<double> weights) const {
  constexpr double kLeast = std::numeric_limits<double>::min();  // for a stone at rest
  const double momentum = Eigen::Map<const Eigen::Vector3d>(y.data()).norm();
  const double radius = std::max(stone_.parameters().radius1, stone_.parameters().radius2);
  std::ranges::fill(weights, 1 / tolerance_);
  std::fill_n(weights.begin(), 3, 1 / std::max(tolerance_ * momentum, kLeast));
  std::fill_n(weights.begin() + kContact, 2, 1 / (tolerance_ * radius));
}

}  // namespace celt
