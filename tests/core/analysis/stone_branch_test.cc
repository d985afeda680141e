#include <cmath>

#include "core/analysis/branch_switch.h"
#include "core/map/celtic_stone_system.h"
#include "gtest/gtest.h"
#include "tests/core/analysis/family.h"

namespace celt {
namespace {

/// The values of tests/reference/celtic_stone.json hold to all their digits; what is asked for.
constexpr double kLocated = 1e-8;

MapFamily StoneInEnergy() {
  return FamilyOf(CelticStoneSystem(), "energy", {}, {.tolerance = 1e-13, .engine = Engine::kFast});
}

ContinuationOptions Interval(double from, double to) {
  ContinuationOptions options;
  options.from = from;
  options.to = to;
  options.longest_step = 0.15;
  options.initial_step = 0.05;
  return options;
}

/// O from above its period doubling to below the meeting of its multipliers.
BranchStretch BranchOfO() {
  const ContinuationOptions options = Interval(748, 747.5);
  BranchState state = Start(StoneInEnergy(), options, {Eigen::Vector3d(2.1438, -0.6612, -0.3749)});
  BranchStretch stretch = WholeBranch(StoneInEnergy(), options, state);
  EXPECT_EQ(state.end, BranchEnd::kReachedEnd) << state.message;
  return stretch;
}

TEST(StoneBranch, FixedPointDoublesItsPeriodAtE1AfterItsMultipliersMet) {
  const BranchStretch stretch = BranchOfO();
  ASSERT_EQ(stretch.bifurcations.size(), 2);
  const Bifurcation& doubling = stretch.bifurcations[0];
  EXPECT_EQ(doubling.type, BifurcationType::kPeriodDoubling);
  EXPECT_NEAR(doubling.point.parameter, 747.7855593694, kLocated);
  EXPECT_EQ(doubling.normal_form.criticality, Criticality::kSupercritical);
  const Bifurcation& meeting = stretch.bifurcations[1];
  EXPECT_EQ(meeting.type, BifurcationType::kMultipliersMeet);
  EXPECT_NEAR(meeting.point.parameter, 747.61004488, kLocated);
}

TEST(StoneBranch, DoubledCycleLosesItsStabilityToASubcriticalTorusAtE4) {
  const ContinuationOptions options = Interval(747.6, 749.2);
  auto state = SwitchToDoubled(StoneInEnergy(), options, BranchOfO().bifurcations.at(0));
  ASSERT_TRUE(state.ok()) << state.status();
  const BranchStretch stretch = WholeBranch(StoneInEnergy(), options, *state);
  EXPECT_EQ(state->end, BranchEnd::kReachedEnd) << state->message;
  const auto met = OfType(stretch.bifurcations, BifurcationType::kNeimarkSacker);
  ASSERT_EQ(met.size(), 1);
  const Bifurcation& torus = met[0];
  EXPECT_NEAR(torus.point.parameter, 748.995888539, kLocated);
  // Half a unit of the reference's last digit.
  EXPECT_NEAR(torus.critical[0].real(), 0.976905, 5e-7);
  EXPECT_NEAR(std::abs(torus.critical[0].imag()), 0.213673, 5e-7);
  EXPECT_NEAR(torus.point.cycle.multipliers[2].real(), 0.709473, 5e-7);
  EXPECT_EQ(torus.normal_form.criticality, Criticality::kSubcritical);
  EXPECT_EQ(torus.resonance, "");
  const Eigen::Vector3d p(2.1105806955, -0.6591090817, -0.3780120419);
  const auto& points = torus.point.cycle.points;
  ASSERT_EQ(points.size(), 2);
  EXPECT_LT(std::min((points[0] - p).norm(), (points[1] - p).norm()), kLocated);
}

}  // namespace
}  // namespace celt
