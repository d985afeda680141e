#include "server/plans/continuation_plan.h"

#include <cmath>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "plans/plan_testing.h"

namespace celt::plans {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr char kStone[] = "numerics { engine: ENGINE_FAST } ";
constexpr char kHenon[] = "system { name: 'henon3d' } ";
/// What is asked of bifurcations of the stone; tests/reference/celtic_stone.json holds to 1e-10.
constexpr double kLocated = 1e-8;

std::string Stone(const std::string& continuation) {
  return std::string(kStone) + "continuation { " + continuation + " }";
}

v1::ContinuationResult ResultOf(const PlanRun& run) {
  EXPECT_TRUE(run.status.ok()) << run.status;
  return run.result.continuation();
}

std::vector<v1::Bifurcation> OfType(const v1::ContinuationResult& result,
                                    v1::BifurcationType type) {
  std::vector<v1::Bifurcation> some;
  for (const v1::Bifurcation& bifurcation : result.bifurcations()) {
    if (bifurcation.type() == type) some.push_back(bifurcation);
  }
  return some;
}

TEST(ContinuationPlan, FollowsTheFixedPointToItsPeriodDoublingAndBeyond) {
  const PlanRun run = RunPlan(Stone("to: 747"));
  const v1::ContinuationResult result = ResultOf(run);
  ASSERT_THAT(result.bifurcations(), SizeIs(2));
  const v1::Bifurcation& doubling = result.bifurcations(0);
  EXPECT_EQ(doubling.type(), v1::PERIOD_DOUBLING);
  EXPECT_NEAR(doubling.value(), 747.7855593694, kLocated);
  EXPECT_LT(doubling.value_error(), kLocated);
  EXPECT_EQ(doubling.criticality(), "supercritical");
  EXPECT_GT(doubling.coefficient(), doubling.coefficient_error());
  EXPECT_NEAR(doubling.critical(0).re(), -1, kLocated);
  EXPECT_FALSE(doubling.has_angle());
  EXPECT_EQ(result.bifurcations(1).type(), v1::MULTIPLIERS_MEET);
  EXPECT_NEAR(result.bifurcations(1).value(), 747.61004488, kLocated);
  EXPECT_FALSE(result.bifurcations(1).has_criticality());

  ASSERT_THAT(result.branches(), SizeIs(1));
  EXPECT_EQ(result.branches(0).end(), "reached the end");
  EXPECT_EQ(result.branches(0).from(), 752);
  EXPECT_EQ(result.branches(0).to(), 747);
  EXPECT_EQ(result.branches(0).points(), result.branch_size());
  EXPECT_EQ(result.branch(0).value(), 752);
  EXPECT_EQ(result.branch(0).arclength(), 0);
  EXPECT_NEAR(result.branch(0).cycle().points(0).l(), 2.147462384985, 1e-9);
  EXPECT_GT(result.accuracy().sample(), 0);
  EXPECT_LT(result.accuracy().map_error(), 1e-11);
}

TEST(ContinuationPlan, RecordsComeInTheOrderOfTravel) {
  const PlanRun run = RunPlan(Stone("from: 748 to: 747.5"));
  double before = 749;
  int bifurcations = 0;
  for (const v1::Record& record : run.records) {
    const v1::ContinuationRecord& piece = record.continuation();
    const double value = piece.has_point() ? piece.point().value() : piece.bifurcation().value();
    EXPECT_LT(value, before);
    before = value;
    bifurcations += piece.has_bifurcation() ? 1 : 0;
    if (!piece.has_point()) continue;
    EXPECT_THAT(piece.point().cycle().lorenz_conditions(), SizeIs(8));
  }
  EXPECT_EQ(bifurcations, 2);
  EXPECT_THAT(run.records, SizeIs(ResultOf(run).branch_size() + 2));
}

TEST(ContinuationPlan, FindsWhereThePeriodTwoCycleLosesItsStability) {
  const v1::ContinuationResult result =
      ResultOf(RunPlan(Stone("from: 748.4 to: 749.5 period: 2 "
                             "near { l: 2.12 l_over_g: -0.6596 h_over_g: -0.377 }")));
  const auto met = OfType(result, v1::NEIMARK_SACKER);
  ASSERT_THAT(met, SizeIs(1));
  EXPECT_NEAR(met[0].value(), 748.995888539, kLocated);
  // Half a unit of the reference's last digit.
  EXPECT_NEAR(met[0].critical(0).re(), 0.976905, 5e-7);
  EXPECT_NEAR(std::abs(met[0].critical(0).im()), 0.213673, 5e-7);
  EXPECT_NEAR(met[0].angle(), std::atan2(0.213673, 0.976905), 1e-6);
  EXPECT_EQ(met[0].criticality(), "subcritical");
  EXPECT_FALSE(met[0].has_resonance());
  EXPECT_NEAR(met[0].cycle().multipliers(2).re(), 0.709473, 5e-7);
  ASSERT_THAT(met[0].cycle().points(), SizeIs(2));
  EXPECT_EQ(met[0].point().l(), met[0].cycle().points(0).l());
}

TEST(ContinuationPlan, FollowsTheDoubledCycleToo) {
  const v1::ContinuationResult result = ResultOf(RunPlan(Stone("to: 747 doublings: 1")));
  ASSERT_THAT(result.branches(), SizeIs(2));
  EXPECT_EQ(result.branches(1).period(), 2);
  EXPECT_EQ(result.branches(1).end(), "came back to the start");
  const auto met = OfType(result, v1::NEIMARK_SACKER);
  ASSERT_THAT(met, SizeIs(1));
  EXPECT_EQ(met[0].branch(), 1);
  EXPECT_NEAR(met[0].value(), 748.995888539, kLocated);
}

/// z of the fixed point of the Henon map with b = m2 = 0.5, a = 0 is √m1: a fold at 0.
TEST(ContinuationPlan, PassesAFoldAndComesBack) {
  const v1::ContinuationResult result = ResultOf(RunPlan(
      "system { name: 'henon3d' parameters { key: 'b' value: 0.5 } parameters { key: 'm2' "
      "value: 0.5 } } continuation { parameter: 'm1' from: 0.25 to: -1 near { x: [0.5, 0.5, "
      "0.5] } }"));
  const auto folds = OfType(result, v1::FOLD);
  ASSERT_THAT(folds, SizeIs(1));
  EXPECT_NEAR(folds[0].value(), 0, 1e-12);
  EXPECT_NEAR(folds[0].point().x(0), 0, kLocated);
  EXPECT_EQ(result.branches(0).end(), "came back to the start");
  EXPECT_NEAR(result.branch().rbegin()->cycle().points(0).x(0), -0.5, 1e-12);
}

TEST(ContinuationPlan, BranchThatLeavesTheDomainKeepsItsPointsAndSaysWhy) {
  // The point of contact runs off to infinity.
  const PlanRun run = RunPlan(
      "numerics { engine: ENGINE_FAST tolerance: 1e-8 } continuation { parameter: "
      "'gravity' to: 1 longest_step: 0.2 }");
  const v1::ContinuationResult result = ResultOf(run);
  EXPECT_GT(result.branch_size(), 10);
  EXPECT_EQ(result.branches(0).end(), "left the domain");
  EXPECT_THAT(result.branches(0).message(), HasSubstr("gamma3"));
}

TEST(ContinuationPlan, FramesFollowTheParameterThatTheyDependOn) {
  const std::string branch = "continuation { parameter: 'delta' to: 0.48 }";
  const auto body = ResultOf(RunPlan(std::string(kStone) + branch));
  const auto paper = ResultOf(RunPlan(std::string(kStone) + "frame: FRAME_PAPER " + branch));
  ASSERT_EQ(body.branch_size(), paper.branch_size());
  for (int i = 0; i < body.branch_size(); ++i) {
    const double delta = body.branch(i).value();
    const double turned = -(body.branch(i).cycle().points(0).l() + delta);
    // The guesses differ by rounding.
    EXPECT_NEAR(std::remainder(paper.branch(i).cycle().points(0).l() - turned, 2 * M_PI), 0, 1e-9);
  }
  // Reference value at delta = 0.48.
  EXPECT_NEAR(body.branch().rbegin()->cycle().points(0).l(), 2.155023737435, 1e-9);
}

TEST(ContinuationPlan, FirstCycleThatIsNotFoundFailsTheJob) {
  const PlanRun run = RunPlan(Stone("from: 751 to: 750 near { l: 1 l_over_g: 0.3 h_over_g: 0.2 }"));
  EXPECT_FALSE(run.status.ok());
  EXPECT_THAT(std::string(run.status.message()),
              HasSubstr("at energy 751: no cycle of period 1 found: "));
  EXPECT_THAT(run.records, SizeIs(0));
}

TEST(ContinuationPlan, EndsAtTheMostPointsAllowed) {
  const PlanRun run = RunPlan(Stone("to: 747 most_points: 5"));
  EXPECT_EQ(ResultOf(run).branches(0).end(), "most points");
  EXPECT_THAT(run.records, SizeIs(5));
  EXPECT_NEAR(run.work, 100, 1e-9);
}

TEST(ContinuationPlan, SameBytesHoweverInterrupted) {
  const v1::JobSpec spec = Resolved(Stone("from: 748 to: 747.5 doublings: 1 longest_step: 0.1"));
  for (const std::int64_t after : {1, 8, 20}) ExpectSameBytesWhenInterrupted(spec, 2, after);
}

TEST(ContinuationPlan, WorkIsAllThereWasToDo) {
  const PlanRun run = RunPlan(Stone("from: 748 to: 747.5 doublings: 3 longest_step: 0.1"));
  EXPECT_NEAR(run.work, 400, 1e-9);
}

TEST(ContinuationPlan, StopsBetweenTwoPoints) {
  const auto plan = MakeContinuationPlan(
      Resolved(std::string(kHenon) + "continuation { parameter: 'm2' to: 0.9 }"));
  const auto begun = (*plan)->Run({0, 0}, "", [] { return false; });
  ASSERT_TRUE(begun.ok()) << begun.status();
  int asked = 0;
  const auto output = (*plan)->Run({1, 0}, begun->checkpoint, [&] { return ++asked > 2; });
  EXPECT_TRUE(absl::IsCancelled(output.status())) << output.status();
  EXPECT_EQ(asked, 3);
}

TEST(ContinuationSpec, FillsInEveryDefault) {
  const v1::ContinuationSpec spec = Resolved("continuation { to: 747 }").continuation();
  EXPECT_EQ(spec.parameter(), "energy");
  EXPECT_EQ(spec.from(), 752);
  EXPECT_EQ(spec.period(), 1);
  EXPECT_EQ(spec.longest_step(), 0.02);
  EXPECT_EQ(spec.most_points(), 10'000);
  EXPECT_TRUE(spec.has_doublings());
  EXPECT_TRUE(spec.near().has_l());
}

TEST(ContinuationSpec, RefusesWhatMakesNoSense) {
  for (const BadSpecification& bad : {
           BadSpecification{"continuation {}", "to:", "missing"},
           BadSpecification{"continuation { to: 752 }", "to:", "other than from"},
           BadSpecification{"continuation { to: nan }", "to:", "nan"},
           BadSpecification{"continuation { from: inf to: 1 }", "from:", "inf"},
           BadSpecification{"continuation { parameter: 'foo' to: 1 }", "parameter:", "delta"},
           BadSpecification{"continuation { parameter: 'mass' to: -1 }", "to:", "(0, inf)"},
           BadSpecification{"continuation { to: 747 period: 0 }", "period:", "0 is not allowed"},
           BadSpecification{"continuation { to: 747 longest_step: 0 }", "longest_step:", "1]"},
           BadSpecification{"continuation { to: 747 longest_step: nan }", "longest_step:", "nan"},
           BadSpecification{"continuation { to: 747 most_points: 1 }", "most_points:", "[2,"},
           BadSpecification{"continuation { to: 747 doublings: 9 }", "doublings:", "[0, 8]"},
           BadSpecification{"continuation { to: 747 near { l: 1 } }", "near:", "l_over_g"},
           BadSpecification{"continuation { from: 10 to: 20 }", "near:", "potential energy"},
       }) {
    ExpectRefused(bad);
  }
}

}  // namespace
}  // namespace celt::plans
