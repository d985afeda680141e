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

}  // namespace
}  // namespace celt::fast
