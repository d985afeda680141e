#include "core/integrate/ode_stepper.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gtest/gtest.h"

namespace celt {
namespace {

/// ẍ = −sin x, not linear, so that every condition of order counts.
class Pendulum final : public OdeProblem {
 public:
  explicit Pendulum(double tolerance) : tolerance_(tolerance) {}
  int size() const override { return 2; }
  bool Rate(std::span<const double> y, std::span<double> rate) const override {
    rate[0] = y[1];
    rate[1] = -std::sin(y[0]);
    return true;
  }
  void Weights(std::span<const double>, std::span<double> weights) const override {
    std::ranges::fill(weights, 1 / tolerance_);
  }

 private:
  double tolerance_;
};

constexpr std::array<double, 2> kStart = {1, 0.5};

int StepsOfRungeKutta(double tolerance) {
  const Pendulum pendulum(tolerance);
  const auto stepper = MakeRungeKuttaStepper(pendulum, kStart);
  int steps = 0;
  for (; stepper->time() != 100.0; ++steps) EXPECT_TRUE(stepper->Step(100).ok());
  return steps;
}

TEST(RungeKuttaStepper, StepsShortenWithTheToleranceAsOfOrderEight) {
  // Steps are as long as the eighth root of the tolerance: 10^(6/8) = 5.6 times as many for a
  // millionth of it. With ARKODE's own table, whose last stage it takes for the result, there are
  // 7.6 times as many.
  const double ratio = static_cast<double>(StepsOfRungeKutta(1e-12)) / StepsOfRungeKutta(1e-6);
  EXPECT_GT(ratio, 4.5);
  EXPECT_LT(ratio, 6.5);
}

TEST(RungeKuttaStepper, LandsOnTheStopExactlyEvenInOneStep) {
  const Pendulum pendulum(1e-10);
  const auto stepper = MakeRungeKuttaStepper(pendulum, kStart, /*first_step=*/-1e-7);
  ASSERT_TRUE(stepper->Step(-1e-7).ok());
  EXPECT_EQ(stepper->time(), -1e-7);
  EXPECT_NEAR(stepper->state()[0], kStart[0] - 1e-7 * kStart[1], 1e-14);
}

TEST(AdamsStepper, NeverStepsBeyondTheStop) {
  const Pendulum pendulum(1e-10);
  const auto stepper = MakeAdamsStepper(pendulum, kStart);
  while (stepper->time() != 1.0) {
    ASSERT_TRUE(stepper->Step(1).ok());
    ASSERT_LE(stepper->time(), 1);
  }
}

}  // namespace
}  // namespace celt
