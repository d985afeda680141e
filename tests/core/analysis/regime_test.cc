#include "core/analysis/regime.h"

#include "core/map/celtic_stone_system.h"
#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

/// A report of three exponents with the same error.
LyapunovReport Report(double first, double second, double third, double error) {
  LyapunovReport report;
  report.batches = 16;
  for (const double value : {first, second, third})
    report.per_iterate.push_back({.value = value, .standard_error = error});
  const auto add = [&report](const char* name, double slack) {
    LyapunovCondition condition;
    condition.name = name;
    condition.holds = slack > 0;
    report.conditions.push_back(condition);
  };
  add("lambda1 > 0", first);
  add("lambda1 + lambda2 > 0", first + second);
  add("lambda1 + lambda2 + lambda3 < 0", -first - second - third);
  add("lambda3 < lambda2", second - third);
  return report;
}

TEST(Regime, IsNamedByTheSignsOfTheExponents) {
  EXPECT_EQ(RegimeOf(Report(-0.03, -0.4, -0.5, 1e-3)), Regime::kPeriodic);
  EXPECT_EQ(RegimeOf(Report(1e-6, -0.4, -0.5, 1e-6)), Regime::kInvariantCurve);
  EXPECT_EQ(RegimeOf(Report(0.02, -0.1, -0.2, 1e-3)), Regime::kChaos);
  EXPECT_EQ(RegimeOf(Report(0.02, -1e-5, -0.2, 1e-4)), Regime::kPseudoHyperbolicCandidate);
}

TEST(Regime, IsNotNamedWhereTheErrorsDoNotAllowIt) {
  EXPECT_EQ(RegimeOf(Report(-0.004, -0.4, -0.5, 2e-3)), Regime::kUnknown);
  EXPECT_EQ(RegimeOf(Report(0.004, -0.4, -0.5, 2e-3)), Regime::kUnknown);
  // A zero with an error in which chaos could hide.
  EXPECT_EQ(RegimeOf(Report(1e-4, -0.02, -0.5, 1e-4)), Regime::kUnknown);
  LyapunovReport single = Report(-0.03, -0.4, -0.5, 0);
  single.batches = 1;
  EXPECT_EQ(RegimeOf(single), Regime::kUnknown);
  LyapunovReport plane = Report(0.4, -1, -2, 1e-3);
  plane.per_iterate.pop_back();
  EXPECT_EQ(RegimeOf(plane), Regime::kUnknown);
}

TEST(Regime, DoesNotMindTheOrder) {
  EXPECT_EQ(RegimeOf(Report(-0.41, -0.4, -0.03, 1e-3)), Regime::kPeriodic);
}

Regime RegimeOfSystem(const System& system, const Parameters& parameters, std::int64_t iterates) {
  const auto map = system.MakeMap(parameters, {});
  EXPECT_TRUE(map.ok()) << map.status();
  std::vector<FramedOrbit> orbits = DrawStarts(system.DefaultStart(), system.StartSpread(), 8, 1);
  const auto go_on = [](std::int64_t) { return true; };
  EXPECT_TRUE(AdvanceFrames(**map, orbits, 1000, go_on).ok());
  const auto sums = AdvanceFrames(**map, orbits, iterates, go_on);
  EXPECT_TRUE(sums.ok()) << sums.status();
  return RegimeOf(Summarize(*sums));
}

TEST(Regime, OfTheStoneAndOfHenonsMap) {
  EXPECT_EQ(RegimeOfSystem(CelticStoneSystem(), {{"energy", 747}}, 100), Regime::kPeriodic);
  EXPECT_EQ(RegimeOfSystem(CelticStoneSystem(), {{"energy", 752}}, 2000),
            Regime::kPseudoHyperbolicCandidate);
  EXPECT_EQ(RegimeOfSystem(Henon3dSystem(), {{"m2", 0.815}}, 10'000),
            Regime::kPseudoHyperbolicCandidate);
}

}  // namespace
}  // namespace celt
