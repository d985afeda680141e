#include "core/integrate/fast/coordinates.h"

#include <vector>

#include "Eigen/Geometry"
#include "gtest/gtest.h"

namespace celt::fast {
namespace {

CelticStone Stone() {
  return CelticStone({.inertia1 = 3,
                      .inertia2 = 5,
                      .inertia3 = 6,
                      .mass = 1.7,
                      .gravity = 11,
                      .radius1 = 4,
                      .radius2 = 3,
                      .height = 0.9,
                      .delta = 0.4});
}

/// One on either side of γ₃ = 0.
std::vector<StoneState> States() {
  StoneState above;
  StoneState below;
  above << 12, -7, 5, Eigen::Vector3d(0.3, -0.5, 0.9).normalized();
  below << -3, 8, 14, Eigen::Vector3d(-0.2, 0.6, -0.7).normalized();
  return {above, below};
}

double Up(const StoneState& state) { return state[5] > 0 ? 1 : -1; }

TEST(FastCoordinates, GoThereAndBack) {
  for (const StoneState& state : States()) {
    const FastState x = FromMomentum(Stone(), state);
    EXPECT_LT((ToMomentum(Stone(), x, Up(state)).state - state).norm(), 1e-14 * state.norm());
  }
}

TEST(FastCoordinates, HaveTheDerivativeThatDifferencesShow) {
  for (const StoneState& state : States()) {
    const FastState x = FromMomentum(Stone(), state);
    const Chart chart = ToMomentum(Stone(), x, Up(state));
    for (int i = 0; i < 5; ++i) {
      constexpr double kStep = 1e-5;  // error: its square, and rounding over it
      const FastState step = kStep * FastState::Unit(i);
      const StoneState difference = (ToMomentum(Stone(), x + step, Up(state)).state -
                                     ToMomentum(Stone(), x - step, Up(state)).state) /
                                    (2 * kStep);
      EXPECT_LT((chart.derivative.col(i) - difference).norm(), 1e-8 * (1 + difference.norm()));
    }
  }
}

TEST(FastCoordinates, TakeTangentsThereAndBack) {
  for (const StoneState& state : States()) {
    // Tangent to |γ| = 1.
    const Eigen::Vector3d gamma = state.tail<3>();
    StoneTangents tangents = StoneTangents::Random();
    tangents.bottomRows<3>() -= gamma * (gamma.transpose() * tangents.bottomRows<3>());
    const FastState x = FromMomentum(Stone(), state);
    const FastTangents ours = FromMomentum(Stone(), x, Up(state), tangents);
    EXPECT_LT((ToMomentum(Stone(), x, Up(state)).derivative * ours - tangents).norm(),
              1e-13 * tangents.norm());
  }
}

}  // namespace
}  // namespace celt::fast
