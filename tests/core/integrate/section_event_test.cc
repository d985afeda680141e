#include "core/integrate/section_event.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "core/model/andoyer.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

constexpr double kRounding = 100 * std::numeric_limits<double>::epsilon();

StoneState SomeState(double g) { return FromAndoyer({.L = -9, .H = 14, .G = 30, .l = 4, .g = g}); }

TEST(SectionEvent, IsTheSineOfTheAngleFromTheSection) {
  const double scale = 30 * std::sqrt(1 - 0.3 * 0.3) * std::sqrt(1 - 14.0 * 14 / 900);
  for (const double angle : {0.0, 1.2, std::numbers::pi, 5.0}) {
    const SectionEvent event(angle);
    for (const double g : {0.1, 1.3, 2.9, 4.4, 6.0}) {
      EXPECT_NEAR(event.Value(SomeState(g)), scale * std::sin(g - angle), kRounding * scale);
      EXPECT_NEAR(event.Side(SomeState(g)), scale * std::cos(g - angle), kRounding * scale);
    }
  }
}

TEST(SectionEvent, HasTheOtherSignForCrossingsTheOtherWay) {
  const SectionEvent increasing(1.2);
  const SectionEvent decreasing(1.2, Crossings::kDecreasing);
  const StoneState y = SomeState(0.8);
  EXPECT_EQ(decreasing.Value(y), -increasing.Value(y));
  EXPECT_EQ(decreasing.Gradient(y), -increasing.Gradient(y));
  EXPECT_EQ(decreasing.Side(y), increasing.Side(y)) << "g0 and g0 + pi stay apart";
}

TEST(SectionEvent, GradientIsItsDerivative) {
  const SectionEvent event(2.5);
  const StoneState y = SomeState(0.8);
  constexpr double kStep =
      1e-5;  // errs by its square and by rounding over it: 1e-9 of numbers of size 30
  for (int j = 0; j < 6; ++j) {
    const StoneState h = kStep * StoneState::Unit(j);
    EXPECT_NEAR(event.Gradient(y)[j], (event.Value(y + h) - event.Value(y - h)) / (2 * kStep),
                1e-8);
  }
}

}  // namespace
}  // namespace celt
