#include "core/analysis/zero.h"

#include <cmath>

#include "absl/status/status.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

ZeroBracket BracketOf(double (*f)(double), double a, double b) {
  return {.a = a, .b = b, .value_a = f(a), .value_b = f(b)};
}

TEST(FindZero, ClosesInOnASimpleZeroInFewEvaluations) {
  int evaluations = 0;
  const auto f = [](double x) { return std::exp(x) - 2; };
  const ZeroResult zero = FindZero(
      [&](double x) -> absl::StatusOr<double> {
        ++evaluations;
        return f(x);
      },
      BracketOf(+f, -5, 3), 1e-12);
  EXPECT_TRUE(zero.complete);
  EXPECT_NEAR(zero.bracket.best(), std::log(2), 1e-12);
  EXPECT_LE(std::abs(zero.bracket.a - zero.bracket.b), 1e-12);
  EXPECT_LT(evaluations, 20) << "bisection takes 43";
}

TEST(FindZero, BisectsAJump) {
  const auto f = [](double x) { return x < 0.3 ? -1.0 : 1.0; };
  const ZeroResult zero =
      FindZero([&](double x) -> absl::StatusOr<double> { return f(x); }, BracketOf(+f, 0, 1), 1e-9);
  EXPECT_TRUE(zero.complete);
  EXPECT_NEAR(zero.bracket.best(), 0.3, 1e-9);
}

TEST(FindZero, FailedEvaluationKeepsTheBracket) {
  const auto f = [](double x) { return x; };
  const ZeroResult zero =
      FindZero([](double) -> absl::StatusOr<double> { return absl::OutOfRangeError("lost"); },
               BracketOf(+f, -1, 2), 1e-9);
  EXPECT_FALSE(zero.complete);
  EXPECT_EQ(zero.bracket.a, -1);
  EXPECT_EQ(zero.bracket.b, 2);
}

}  // namespace
}  // namespace celt
