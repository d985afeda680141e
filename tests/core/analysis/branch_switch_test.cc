#include "core/analysis/branch_switch.h"

#include <cmath>
#include <vector>

#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"
#include "tests/core/analysis/family.h"
#include "tests/core/analysis/henon_fixed_point.h"

namespace celt {
namespace {

constexpr HenonFixedPoints kHenon = {.m2 = 0.1, .a = 0.2, .b = 0.3};

MapFamily HenonInM1() {
  return FamilyOf(Henon3dSystem(), "m1", {{"m2", kHenon.m2}, {"a", kHenon.a}, {"b", kHenon.b}});
}

ContinuationOptions Interval(double from, double to) {
  ContinuationOptions options;
  options.from = from;
  options.to = to;
  return options;
}

Bifurcation Doubling() {
  const ContinuationOptions options = Interval(0, kHenon.M1(kHenon.DoublingX()) + 0.1);
  BranchState state = Start(HenonInM1(), options, {Point::Constant(3, 0.1)});
  const auto met = OfType(WholeBranch(HenonInM1(), options, state).bifurcations,
                          BifurcationType::kPeriodDoubling);
  EXPECT_EQ(met.size(), 1);
  return met.at(0);
}

/// Points u, v of a cycle of period 2 have u + v = S and u v = P (cycle_test.cc).
void ExpectDoubled(const BranchPoint& point) {
  const double sum = 1 + kHenon.b + kHenon.a - kHenon.m2;
  const double product =
      (sum * (1 - kHenon.b - kHenon.m2 - kHenon.a) + sum * sum - 2 * point.parameter) / 2;
  const double u = point.cycle.points[0][0];
  const double v = point.cycle.points[0][1];
  EXPECT_EQ(point.cycle.minimal_period, 2);
  // Newton's method ends at rounding.
  EXPECT_NEAR(u + v, sum, 1e-12);
  EXPECT_NEAR(u * v, product, 1e-12);
}

TEST(SwitchToDoubled, FollowsTheDoubledCycleOfTheHenonMap) {
  const Bifurcation doubling = Doubling();
  const double from = doubling.point.parameter;
  const ContinuationOptions options = Interval(from - 0.2, from + 0.3);
  auto state = SwitchToDoubled(HenonInM1(), options, doubling);
  ASSERT_TRUE(state.ok()) << state.status();
  ASSERT_EQ(state->points, 1) << state->message;
  ExpectDoubled(state->point);
  const BranchStretch stretch = WholeBranch(HenonInM1(), options, *state);
  EXPECT_EQ(state->end, BranchEnd::kReachedEnd) << state->message;
  for (const BranchPoint& point : stretch.points) ExpectDoubled(point);
}

TEST(SwitchToDoubled, DoubledCycleIsStableAsTheNormalFormSays) {
  const Bifurcation doubling = Doubling();
  EXPECT_EQ(doubling.normal_form.criticality, Criticality::kSupercritical);
  const double from = doubling.point.parameter;
  const auto state = SwitchToDoubled(HenonInM1(), Interval(from - 0.2, from + 0.3), doubling);
  ASSERT_TRUE(state.ok()) << state.status();
  EXPECT_LT(std::abs(state->point.cycle.multipliers[0]), 1);
}

TEST(SwitchToDoubled, WayBackEndsWhereThePeriodHalves) {
  const Bifurcation doubling = Doubling();
  const double at = doubling.point.parameter;
  const ContinuationOptions out = Interval(at - 0.2, at + 0.3);
  auto away = SwitchToDoubled(HenonInM1(), out, doubling);
  ASSERT_TRUE(away.ok()) << away.status();
  WholeBranch(HenonInM1(), out, *away);
  const ContinuationOptions back = Interval(at + 0.3, at - 0.2);
  BranchState state = Start(HenonInM1(), back, away->point.cycle.points);
  WholeBranch(HenonInM1(), back, state);
  EXPECT_EQ(state.end, BranchEnd::kPeriodHalved) << state.message;
  EXPECT_GE(state.point.parameter, at);
  EXPECT_NEAR(state.point.parameter, at, 0.01);
}

TEST(SwitchToDoubled, BadInputIsNamed) {
  Bifurcation fold;
  fold.type = BifurcationType::kFold;
  EXPECT_EQ(SwitchToDoubled(HenonInM1(), Interval(0, 1), fold).status().message(),
            "bifurcation: FOLD is not allowed; it is PERIOD_DOUBLING");
}

}  // namespace
}  // namespace celt
