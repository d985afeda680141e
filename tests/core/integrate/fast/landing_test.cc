#include "core/integrate/fast/landing.h"

#include <cmath>

#include "gtest/gtest.h"

namespace celt::fast {
namespace {

TEST(PartWeights, IntegratePolynomialsUpToTheSeventhDegree) {
  for (const double part : {0.1, 0.5, 0.93, 1.0}) {
    const auto weights = PartWeights(part);
    for (int degree = 0; degree < static_cast<int>(kInterpolated.size()); ++degree) {
      double integral = 0;
      for (std::size_t j = 0; j < weights.size(); ++j) {
        integral += weights[j] * std::pow(kNodes[kInterpolated[j]], degree);
      }
      // Polynomials with coefficients of up to 2,600 that cancel, eight of them, each rounded.
      EXPECT_NEAR(integral, std::pow(part, degree + 1) / (degree + 1), 8 * 2600 * 1.1e-16)
          << part << " " << degree;
    }
  }
}

TEST(FindCrossing, FindsTheZeroToAMillionthInThreeCalls) {
  int calls = 0;
  const auto value = [&](double part) {
    ++calls;
    return std::sin(0.2 * (part - 0.3)) + 0.01 * (part - 0.3) * part;
  };
  const PartValue low{0, value(0)};
  const PartValue high{0.5, value(0.5)};
  const PartValue other{1, value(1)};
  calls = 0;
  EXPECT_NEAR(FindCrossing(low, high, other, value), 0.3, 1e-6);
  EXPECT_LE(calls, 3);
}

TEST(FindCrossing, StaysBetweenItsEndsWhereInterpolationDoesNot) {
  // Flat, then steep: the polynomial through the values is not monotone.
  const auto value = [](double part) { return std::pow(part, 15) - 0.5; };
  const double part = FindCrossing({0.4, value(0.4)}, {1, value(1)}, {0, value(0)}, value);
  EXPECT_GT(part, 0.4);
  EXPECT_LT(part, 1);
}

TEST(FindCrossing, TakesEqualValues) {
  const auto value = [](double part) { return part < 0.5 ? -1.0 : 1.0; };
  const double part = FindCrossing({0, -1}, {1, 1}, {0.25, -1}, value);
  EXPECT_TRUE(part >= 0 && part <= 1) << part;
}

/// (e, side) along a circle around a point, from `start` on by `turn` radians a step.
auto OnACircle(double start, double turn, double center, double radius) {
  return [=](double part) {
    const double angle = start + turn * part;
    return Look{part, center + radius * std::sin(angle), radius * std::cos(angle)};
  };
}

TEST(CrossingPart, IsWhereEGrowsThroughZeroOnTheSectionsSide) {
  const auto upward = OnACircle(-0.3, 0.8, 0, 1);
  const auto part = CrossingPart(upward(0), upward(1), upward(0.5), upward);
  ASSERT_TRUE(part.has_value());
  EXPECT_NEAR(*part, 0.375, 1e-6);
  // Downward, and upward half a turn away.
  const auto downward = OnACircle(0.3, -0.8, 0, 1);
  EXPECT_FALSE(CrossingPart(downward(0), downward(1), downward(0.5), downward).has_value());
  const auto away = OnACircle(3.4, -0.8, 0, 1);
  EXPECT_FALSE(CrossingPart(away(0), away(1), away(0.5), away).has_value());
}

TEST(CrossingPart, IsFoundWhereEChangesItsSignTwice) {
  // The circle dips below e = 0 only between −2.02 and −1.12.
  const auto twice = OnACircle(-2.2, 1.3, 0.9, 1);
  ASSERT_GT(twice(0).value, 0);
  ASSERT_GT(twice(1).value, 0);
  const auto part = CrossingPart(twice(0), twice(1), twice(0.5), twice);
  ASSERT_TRUE(part.has_value());
  EXPECT_NEAR(twice(*part).value, 0, 1e-6);
  EXPECT_GT(twice(*part).side, 0);
}

}  // namespace
}  // namespace celt::fast
