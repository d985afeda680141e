#include "server/plans/manifold_plan.h"

#include <algorithm>
#include <cmath>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "plans/plan_testing.h"
#include "server/plans/manifold_state.h"

namespace celt::plans {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

/// Of the fixed point (0.55, 0.55, 0.55), with a negative multiplier.
std::string Henon(const std::string& manifold) {
  return "system { name: 'henon3d' } manifold { near { x: [0.55, 0.55, 0.55] } " + manifold + " }";
}

std::string Stone(double energy, const std::string& manifold) {
  return "numerics { engine: ENGINE_FAST } system { parameters { key: 'energy' value: " +
         std::to_string(energy) + " } } manifold { " + manifold + " }";
}

v1::ManifoldRecord At(const PlanRun& run, std::size_t i) { return run.records.at(i).manifold(); }

TEST(ManifoldPlan, GivesBothSidesInOrderOfArcLength) {
  const PlanRun run = RunPlan(Henon("length: 4 spacing: 0.02"));
  ASSERT_TRUE(run.status.ok()) << run.status;
  const v1::ManifoldResult& result = run.result.manifold();
  ASSERT_THAT(result.sides(), SizeIs(2));
  EXPECT_EQ(result.saddle().type(), "saddle 2-1");
  EXPECT_NEAR(result.saddle().points(0).x(0), 0.55, 1e-12);
  const std::int64_t first = result.sides(0).points();
  EXPECT_EQ(first + result.sides(1).points(), std::ssize(run.records));
  for (std::int64_t i = 0; i < std::ssize(run.records); ++i) {
    const v1::ManifoldRecord at = At(run, i);
    EXPECT_EQ(at.side(), i < first ? 1 : -1);
    if (i == 0 || i == first) continue;
    const v1::ManifoldRecord before = At(run, i - 1);
    const double step = at.arc_length() - before.arc_length();
    EXPECT_GT(step, 0);
    EXPECT_LE(step, 0.02);
    EXPECT_GE(at.generation(), before.generation());
  }
  for (const v1::ManifoldSide& side : result.sides()) {
    EXPECT_EQ(side.end(), "length");
    EXPECT_GE(side.length(), 4);
    EXPECT_LE(side.length(), 4.02);
  }
  // What was recorded, but for less than a spacing at either end of either side.
  EXPECT_NEAR(run.work, 8, 0.1);
}

TEST(ManifoldPlan, RecordsAreOnTheManifold) {
  // Each is the image of another record: the curve is invariant. The distance of the image from the
  // polygon is a matter of its bends, at most spacing times turning.
  const PlanRun run = RunPlan(Henon("length: 1 spacing: 0.01"));
  const auto distance = [&run](const Point& x) {
    double least = INFINITY;
    for (const v1::Record& record : run.records) {
      const auto& y = record.manifold().point().x();
      least = std::min(least, (x - Eigen::Vector3d(y[0], y[1], y[2])).norm());
    }
    return least;
  };
  const auto map = MakeMap(Resolved(Henon("")));
  ASSERT_GT(run.records.size(), 100U);
  for (std::size_t i = 0; i < run.records.size() / 4; ++i) {
    const v1::Point at = At(run, i).point();
    const auto image = (*map)->Apply(Eigen::Vector3d(at.x(0), at.x(1), at.x(2)),
                                     celt::Direction::kForward, Derivative::kNone);
    EXPECT_LT(distance(image->point), 0.01);
  }
}

TEST(ManifoldPlan, SeparatrixSwitchesSidesAtTheButterfly) {
  // E2 = 748.4394655: below, each separatrix comes back on its own side, above on the other.
  const PlanRun below = RunPlan(Stone(748.4, "length: 0.001"));
  const PlanRun above = RunPlan(Stone(748.5, "length: 0.001"));
  for (const int side : {0, 1}) {
    EXPECT_EQ(below.result.manifold().sides(side).fate().changes(), 0);
    EXPECT_EQ(above.result.manifold().sides(side).fate().changes(), 1);
    EXPECT_EQ(below.result.manifold().sides(side).fate().end(), "tends to a cycle");
  }
}

TEST(ManifoldPlan, StableManifoldIsThatOfTheInverse) {
  // At b = 1.5, m2 = 0 the fixed point 1/2 has one multiplier inside the unit circle, l^3 = 1.5 -
  // l^2.
  const PlanRun run = RunPlan(
      "system { name: 'henon3d' parameters { key: 'b' value: 1.5 } parameters { key: 'm2' value: 0 "
      "} } manifold { near { x: [0.5, 0.5, 0.5] } stable: true length: 0.3 }");
  ASSERT_TRUE(run.status.ok()) << run.status;
  EXPECT_EQ(run.result.manifold().saddle().type(), "saddle-focus 1-2");
  EXPECT_EQ(run.result.manifold().sides(0).end(), "length");
}

TEST(ManifoldPlan, MeasuresItsAccuracyOnBothSides) {
  const PlanRun run = RunPlan(Stone(752, "length: 0.05"));
  const v1::Accuracy& accuracy = run.result.manifold().accuracy();
  EXPECT_GE(accuracy.sample(), 8);
  EXPECT_GT(accuracy.map_error(), 0);
  EXPECT_LT(accuracy.map_error(), 1e-9);
}

TEST(ManifoldPlan, CycleThatIsNoSaddleIsAFailureWithItsMultipliers) {
  const PlanRun run = RunPlan(Stone(747, ""));  // where O is stable
  EXPECT_EQ(run.status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(run.status.message()), HasSubstr("Its multipliers: 0.9737"));
  const PlanRun stable = RunPlan(Stone(752, "stable: true"));
  EXPECT_THAT(std::string(stable.status.message()), HasSubstr("has 2 multipliers inside"));
}

TEST(ManifoldPlan, GuessThatLeadsNowhereIsAFailure) {
  // x = m1 + 1.55 x - x^2 has no solution for m1 = -10.
  const PlanRun run =
      RunPlan("system { name: 'henon3d' parameters { key: 'm1' value: -10 } } manifold {}");
  EXPECT_FALSE(run.status.ok());
  EXPECT_THAT(std::string(run.status.message()), HasSubstr("no cycle of period 1 found"));
}

TEST(ManifoldPlan, SideThatLeavesTheDomainKeepsItsPoints) {
  // Below the fixed point -0.98 of m1 = 1.5, z^2 sends everything to infinity.
  const PlanRun run = RunPlan(
      "system { name: 'henon3d' parameters { key: 'm1' value: 1.5 } } "
      "manifold { near { x: [-1, -1, -1] } length: 1000000 spacing: 1000 }");
  ASSERT_TRUE(run.status.ok()) << run.status;
  const auto& sides = run.result.manifold().sides();
  const auto lost = std::find_if(sides.begin(), sides.end(),
                                 [](const v1::ManifoldSide& side) { return side.end() == "lost"; });
  ASSERT_NE(lost, sides.end());
  EXPECT_GT(lost->points(), 10);
  EXPECT_THAT(lost->message(), HasSubstr("escapes"));
}

TEST(ManifoldPlan, SameBytesHoweverInterrupted) {
  ExpectSameBytesWhenInterrupted(Resolved(Henon("length: 6")), 2, 500);
}

TEST(ManifoldPlan, UnitsHaveFewRecords) {
  const PlanRun run = RunPlan(Henon("length: 6 spacing: 0.0005"));
  EXPECT_GT(run.records.size(), 20'000U);
  EXPECT_GT(run.units, std::ssize(run.records) / 4000);
}

TEST(ManifoldState, ComesBackToTheLastBit) {
  ManifoldSide side;
  side.side = -1;
  side.step = 1.0 / 3;
  side.generation = 7;
  side.s = {0, 1.0 / 7, 1};
  side.points = {Eigen::Vector2d(1, 2), Eigen::Vector2d(-0.0, 1e-310), Eigen::Vector2d(5, 6)};
  side.images = {Eigen::Vector2d(0.1, 0.2)};
  side.refining = true;
  side.visited = 2;
  side.arc_length = 0.7;
  side.written = 9;
  side.end = ManifoldEnd::kTorn;
  side.message = "why";
  side.done = true;
  const auto again = DecodeSide(EncodeSide(side), 2);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(EncodeSide(*again), EncodeSide(side));
  EXPECT_EQ(again->points, side.points);
  EXPECT_TRUE(std::signbit(again->points[1][0]));
  EXPECT_TRUE(again->refining && again->done);
  EXPECT_EQ(again->end, ManifoldEnd::kTorn);
  EXPECT_FALSE(DecodeSide(EncodeSide(side), 3).ok());
}

TEST(ManifoldSpec, FillsInEveryDefault) {
  const v1::ManifoldSpec spec = Resolved("manifold {}").manifold();
  EXPECT_EQ(spec.period(), 1);
  EXPECT_EQ(spec.length(), 1);
  EXPECT_EQ(spec.spacing(), 0.01);
  EXPECT_EQ(spec.turning(), 0.3);
  EXPECT_EQ(spec.most_points(), 200'000);
  EXPECT_TRUE(spec.near().has_l());
}

TEST(ManifoldSpec, RefusesWhatMakesNoSense) {
  for (const BadSpecification& bad : {
           BadSpecification{"manifold { period: 0 }", "period:", "[1, 256]"},
           BadSpecification{"manifold { period: 257 }", "period:", "257"},
           BadSpecification{"manifold { length: 0 }", "length:", "0 is not allowed"},
           BadSpecification{"manifold { length: nan }", "length:", "nan"},
           BadSpecification{"manifold { spacing: -1 }", "spacing:", "-1"},
           BadSpecification{"manifold { turning: 4 }", "turning:", "4"},
           BadSpecification{"manifold { most_points: 1 }", "most_points:", "[2, 1000000]"},
           BadSpecification{"manifold { near { l: 1 l_over_g: 1 h_over_g: 0 } }", "near:", "1"},
       }) {
    ExpectRefused(bad);
  }
}

}  // namespace
}  // namespace celt::plans
