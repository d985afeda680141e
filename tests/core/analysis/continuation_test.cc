#include "core/analysis/continuation.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"
#include "tests/core/analysis/family.h"
#include "tests/core/analysis/henon_fixed_point.h"

namespace celt {
namespace {

constexpr HenonFixedPoints kHenon = {.m2 = 0.8, .a = -0.2, .b = 0.6};

MapFamily HenonInM1() {
  return FamilyOf(Henon3dSystem(), "m1", {{"m2", kHenon.m2}, {"a", kHenon.a}, {"b", kHenon.b}});
}

/// From one fixed point at m1 = 0.3 round the fold at −0.01 to the other at 0.3.
ContinuationOptions RoundTheFold() {
  ContinuationOptions options;
  options.from = 0.3;
  options.to = -1;
  return options;
}

std::vector<Point> UpperPoint() { return {Point::Constant(3, 0.65)}; }

TEST(Continuation, FollowsFixedPointsOfTheHenonMapRoundTheirFold) {
  BranchState state = Start(HenonInM1(), RoundTheFold(), UpperPoint());
  const BranchStretch stretch = WholeBranch(HenonInM1(), RoundTheFold(), state);
  EXPECT_EQ(state.end, BranchEnd::kReachedStart) << state.message;
  for (const BranchPoint& point : stretch.points) {
    const double x = point.cycle.points[0][0];
    // Newton's method ends at rounding.
    EXPECT_NEAR(kHenon.M1(x), point.parameter, 1e-13);
  }
  // The other zero of the quadratic.
  EXPECT_EQ(state.point.parameter, 0.3);
  EXPECT_NEAR(state.point.cycle.points[0][0], 0.1 - std::sqrt(0.01 + 0.3), 1e-13);
}

TEST(Continuation, LastPointLiesAtTheEndOfTheInterval) {
  ContinuationOptions options;
  options.from = 0;
  options.to = 0.37;
  BranchState state = Start(HenonInM1(), options, {Point::Constant(3, 0.2)});
  WholeBranch(HenonInM1(), options, state);
  EXPECT_EQ(state.end, BranchEnd::kReachedEnd);
  EXPECT_EQ(state.point.parameter, 0.37);
}

TEST(Continuation, StepsAndTurnsKeepTheirLimits) {
  const ContinuationOptions options = RoundTheFold();
  BranchState state = Start(HenonInM1(), options, UpperPoint());
  BranchPoint before = state.point;
  for (const BranchPoint& point : WholeBranch(HenonInM1(), options, state).points) {
    EXPECT_GE(point.tangent.dot(before.tangent), std::cos(options.most_turn));
    // A step is measured along the tangent; the chord is longer by at most 1/cos(turn).
    EXPECT_LE(point.arclength - before.arclength,
              options.longest_step / std::cos(options.most_turn));
    EXPECT_NEAR(point.tangent.norm(), 1, 1e-15);
    before = point;
  }
}

TEST(Continuation, BranchCutIntoPiecesIsTheSameToTheLastBit) {
  const ContinuationOptions options = RoundTheFold();
  BranchState whole = Start(HenonInM1(), options, UpperPoint());
  const BranchStretch stretch = WholeBranch(HenonInM1(), options, whole);
  BranchState cut = Start(HenonInM1(), options, UpperPoint());
  std::vector<BranchPoint> points;
  std::size_t bifurcations = 0;
  while (cut.end == BranchEnd::kNone) {
    BranchState copy = cut;
    const auto piece = AdvanceBranch(HenonInM1(), options, copy, 7, [] { return true; });
    ASSERT_TRUE(piece.ok()) << piece.status();
    points.insert(points.end(), piece->points.begin(), piece->points.end());
    bifurcations += piece->bifurcations.size();
    cut = copy;
  }
  ASSERT_EQ(points.size(), stretch.points.size());
  EXPECT_EQ(bifurcations, stretch.bifurcations.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].parameter, stretch.points[i].parameter);
    EXPECT_EQ(points[i].cycle.points[0], stretch.points[i].cycle.points[0]);
    EXPECT_EQ(points[i].arclength, stretch.points[i].arclength);
  }
}

TEST(Continuation, EdgeOfTheParametersRangeIsReportedAndTheBranchKept) {
  const MapFamily inner = HenonInM1();
  const MapFamily family = [&inner](double m1) -> absl::StatusOr<std::unique_ptr<Map>> {
    if (m1 < 0.1) return absl::InvalidArgumentError(absl::StrCat("m1: ", m1, " is too small"));
    return inner(m1);
  };
  BranchState state = Start(family, RoundTheFold(), UpperPoint());
  const BranchStretch stretch = WholeBranch(family, RoundTheFold(), state);
  EXPECT_EQ(state.end, BranchEnd::kLeftDomain);
  EXPECT_NE(state.message.find("is too small"), std::string::npos) << state.message;
  EXPECT_GT(stretch.points.size(), 5);
  // As near as differences over twice their step, 0.0026, can be formed.
  EXPECT_NEAR(stretch.points.back().parameter, 0.1, 0.003);
}

TEST(Continuation, MostPointsEndsTheBranch) {
  ContinuationOptions options = RoundTheFold();
  options.most_points = 5;
  BranchState state = Start(HenonInM1(), options, UpperPoint());
  EXPECT_EQ(WholeBranch(HenonInM1(), options, state).points.size(), 4) << "and the first";
  EXPECT_EQ(state.end, BranchEnd::kMostPoints);
}

TEST(Continuation, StartWithoutACycleSaysWhy) {
  ContinuationOptions options = RoundTheFold();
  options.from = -0.5;
  const BranchState state = Start(HenonInM1(), options, UpperPoint());
  EXPECT_EQ(state.points, 0);
  EXPECT_EQ(state.end, BranchEnd::kNoConvergence);
  EXPECT_FALSE(state.message.empty());
}

TEST(Continuation, TickCancels) {
  BranchState state = Start(HenonInM1(), RoundTheFold(), UpperPoint());
  const auto stretch = AdvanceBranch(HenonInM1(), RoundTheFold(), state, 100, [] { return false; });
  EXPECT_EQ(stretch.status().code(), absl::StatusCode::kCancelled);
}

TEST(Continuation, BadInputIsNamed) {
  ContinuationOptions options = RoundTheFold();
  options.to = options.from;
  EXPECT_EQ(CheckContinuation(options).message(),
            "to: 0.3 is not allowed; it is a finite number other than from");
  options = RoundTheFold();
  options.longest_step = 2;
  EXPECT_EQ(CheckContinuation(options).message(),
            "longest_step: 2 is not allowed; it lies in (0, 1]");
  options = RoundTheFold();
  options.from = std::nan("");
  EXPECT_EQ(CheckContinuation(options).message(), "from: nan is not a finite number");
  options = RoundTheFold();
  options.initial_step = 0.1;
  EXPECT_EQ(CheckContinuation(options).code(), absl::StatusCode::kInvalidArgument);
}

TEST(ParameterDerivative, OfTheHenonMapIsExactAndSaysItsError) {
  const MapFamily family = FamilyOf(Henon3dSystem(), "m2", {{"m1", 0.3}});
  const BranchEquation equation(family, 1, 1e-3, {});
  const auto derivative = equation.DifferentiateByParameter(
      {.points = {Eigen::Vector3d(0.3, 0.4, 0.5)}, .parameter = 0.8});
  ASSERT_TRUE(derivative.ok());
  EXPECT_EQ(derivative->step, 1e-3);
  // z̄ contains m2 y: linear, so that rounding over the step is all.
  EXPECT_LT((derivative->value - Eigen::Vector3d(0, 0, 0.4)).norm(), 1e-12);
  EXPECT_LT(derivative->error, 1e-12);
}

TEST(ParameterDerivative, ErrorCoversACubicDependence) {
  const MapFamily family = [](double p) {
    return Henon3dSystem().MakeMap({{"m1", std::sin(p)}}, {});
  };
  const BranchEquation equation(family, 1, 0.05, {});
  const auto derivative = equation.DifferentiateByParameter(
      {.points = {Eigen::Vector3d(0.3, 0.4, 0.5)}, .parameter = 0.7});
  ASSERT_TRUE(derivative.ok());
  const double error = std::abs(derivative->value[2] - std::cos(0.7));
  EXPECT_GT(derivative->error, error);
  // 4 h⁴ sin⁽⁵⁾/5!, the first term left out.
  EXPECT_LT(error, 4 * std::pow(0.05, 4) / 120);
}

}  // namespace
}  // namespace celt
