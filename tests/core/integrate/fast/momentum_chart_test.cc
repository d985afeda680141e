// For the one target that the compiler is set to; the engine's own tests compare them all.
#include <vector>

#include "Eigen/Geometry"
#include "core/integrate/fast/coordinates.h"
#include "core/integrate/fast/momentum_chart-inl.h"
#include "gtest/gtest.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {
namespace {

using One = Lanes<1>;

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

/// (M/m, γ), one on either side of γ₃ = 0.
std::vector<StoneState> States() {
  StoneState above;
  StoneState below;
  above << 12, -7, 5, Eigen::Vector3d(0.3, -0.5, 0.9).normalized();
  below << -3, 8, 14, Eigen::Vector3d(-0.2, 0.6, -0.7).normalized();
  return {above, below};
}

double Up(const StoneState& state) { return state[5] > 0 ? 1 : -1; }

template <class Vector>
void Unpack(const Vector& v, One* out) {
  for (int i = 0; i < v.size(); ++i) out[i] = Set<One>(v[i]);
}

template <int kSize>
Eigen::Matrix<double, kSize, 1> Repack(const One* v) {
  Eigen::Matrix<double, kSize, 1> out;
  for (int i = 0; i < kSize; ++i) out[i] = hn::GetLane(v[i]);
  return out;
}

MomentumChart<One> ChartAt(const FastState& x, double up) {
  One in[kComponents];
  Unpack(x, in);
  return {StoneConstants(Stone()), Set<One>(up), in};
}

StoneState StateAt(const FastState& x, double up) { return Repack<6>(ChartAt(x, up).state); }

VelocityChart<One> ChartAt(const StoneState& state) {
  One in[kChartSize];
  Unpack(state, in);
  return {StoneConstants(Stone()), in};
}

FastState VelocityAt(const StoneState& state) { return Repack<5>(ChartAt(state).x); }

TEST(MomentumChart, GivesTheStateOfTheModel) {
  for (const StoneState& state : States()) {
    const FastState x = VelocityAt(state);
    StoneState whole = StateAt(x, Up(state));
    whole.head<3>() *= Stone().parameters().mass;
    EXPECT_LT((whole - ToMomentum(Stone(), x, Up(state))).norm(), 1e-14 * whole.norm());
    EXPECT_LT((Stone().AngularVelocity(whole) - x.head<3>()).norm(), 1e-13 * x.norm());
  }
}

TEST(MomentumChart, GoesThereAndBack) {
  for (const StoneState& state : States()) {
    // ω follows from M by a matrix with a condition of some tens.
    EXPECT_LT((StateAt(VelocityAt(state), Up(state)) - state).norm(), 1e-14 * state.norm());
  }
}

TEST(MomentumChart, HasTheDerivativeThatDifferencesShow) {
  for (const StoneState& state : States()) {
    const FastState x = VelocityAt(state);
    const MomentumChart<One> chart = ChartAt(x, Up(state));
    for (int i = 0; i < kComponents; ++i) {
      constexpr double kStep = 1e-5;  // error: its square, and rounding over it
      const FastState step = kStep * FastState::Unit(i);
      const StoneState difference =
          (StateAt(x + step, Up(state)) - StateAt(x - step, Up(state))) / (2 * kStep);
      One unit[kComponents], pushed[kChartSize];
      Unpack(FastState(FastState::Unit(i)), unit);
      chart.Push(unit, pushed);
      EXPECT_LT((Repack<6>(pushed) - difference).norm(), 1e-8 * (1 + difference.norm()));
    }
  }
}

TEST(MomentumChart, TakesTangentsThereAndBack) {
  for (const StoneState& state : States()) {
    StoneState tangent;
    tangent << 0.3, -2, 1.1, 0.7, 0.2, -0.9;
    const Eigen::Vector3d gamma = state.tail<3>();
    tangent.tail<3>() -= gamma * gamma.dot(tangent.tail<3>());  // tangent to |γ| = 1
    One in[kChartSize], x[kComponents], out[kChartSize];
    Unpack(tangent, in);
    ChartAt(state).Push(in, x);
    ChartAt(VelocityAt(state), Up(state)).Push(x, out);
    EXPECT_LT((Repack<6>(out) - tangent).norm(), 1e-13 * tangent.norm());
  }
}

}  // namespace
}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
