#include "server/plans/fixed_point_plan.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "plans/plan_testing.h"

namespace celt::plans {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr char kHenon[] = "system { name: 'henon3d' } ";
constexpr char kStone[] = "numerics { engine: ENGINE_FAST } ";
/// tests/reference/celtic_stone.json holds to about 1e-11, the map's multipliers at the default
/// tolerance of 1e-13 to 1e-10.
constexpr double kAsReference = 1e-9;

std::string AtEnergy(const std::string& energy, const std::string& analysis) {
  return std::string(kStone) + "system { parameters { key: 'energy' value: " + energy + " } } " +
         analysis;
}

v1::FixedPointResult ResultOf(const PlanRun& run) {
  EXPECT_TRUE(run.status.ok()) << run.status;
  return run.result.fixed_point();
}

double Modulus(const v1::Multiplier& multiplier) {
  return std::hypot(multiplier.re(), multiplier.im());
}

TEST(FixedPointPlan, FindsThePapersFixedPointFromTheKnownStart) {
  const v1::FixedPointResult result = ResultOf(RunPlan(std::string(kStone) + "fixed_point {}"));
  ASSERT_THAT(result.cycles(), SizeIs(1));
  const v1::Cycle& cycle = result.cycles(0);
  EXPECT_NEAR(cycle.points(0).l(), 2.147462384985, kAsReference);
  EXPECT_NEAR(cycle.points(0).l_over_g(), -0.669144118368, kAsReference);
  EXPECT_NEAR(cycle.points(0).h_over_g(), -0.384701258034, kAsReference);
  EXPECT_NEAR(cycle.return_time(), 0.792136027186, kAsReference);
  EXPECT_NEAR(cycle.multipliers(0).re(), -1.3126468422, kAsReference);
  EXPECT_NEAR(cycle.multipliers(1).re(), 0.9660613332, kAsReference);
  EXPECT_NEAR(cycle.multipliers(2).re(), -0.6647208898, kAsReference);
  EXPECT_EQ(cycle.type(), "saddle 2-1");
  EXPECT_THAT(cycle.sides(), ElementsAre(-1, 1, -1));
  for (const v1::Inequality& condition : cycle.lorenz_conditions()) {
    EXPECT_TRUE(condition.holds()) << condition.name();
  }
  EXPECT_THAT(cycle.lorenz_conditions(), SizeIs(8));
  EXPECT_EQ(result.accuracy().sample(), 1);
  EXPECT_LT(result.accuracy().map_error(), kAsReference / 10);
}

TEST(FixedPointPlan, RecordIsTheCycleOfTheResult) {
  const PlanRun run = RunPlan(std::string(kHenon) + "fixed_point { near { x: [0.5, 0.6, 0.5] } }");
  ASSERT_THAT(run.records, SizeIs(1));
  const v1::FixedPointResult result = ResultOf(run);
  EXPECT_EQ(Serialize(run.records[0].fixed_point().cycle()), Serialize(result.cycles(0)));
  EXPECT_FALSE(run.records[0].fixed_point().has_first_start());
  // b + m2 − 1.
  EXPECT_NEAR(result.cycles(0).points(0).x(2), 0.55, 1e-14);
  EXPECT_EQ(result.cycles(0).return_time(), 1);
}

TEST(FixedPointPlan, FindsThePeriodTwoCycleWhereItsTorusIsBorn) {
  const v1::FixedPointResult result = ResultOf(RunPlan(
      AtEnergy("748.995888539",
               "fixed_point { period: 2 near { l: 2.11 l_over_g: -0.659 h_over_g: -0.378 } }")));
  const v1::Cycle& cycle = result.cycles(0);
  ASSERT_THAT(cycle.points(), SizeIs(2));
  EXPECT_NEAR(cycle.points(0).l(), 2.1105806955, kAsReference);
  EXPECT_NEAR(cycle.points(0).l_over_g(), -0.6591090817, kAsReference);
  EXPECT_NEAR(cycle.points(0).h_over_g(), -0.3780120419, kAsReference);
  // Half a unit of the last digit that is known.
  EXPECT_NEAR(cycle.multipliers(0).re(), 0.976905, 5e-7);
  EXPECT_NEAR(cycle.multipliers(0).im(), 0.213673, 5e-7);
  EXPECT_NEAR(cycle.multipliers(2).re(), 0.709473, 5e-7);
  EXPECT_NEAR(Modulus(cycle.multipliers(0)), 1, 1e-9);
}

TEST(FixedPointPlan, PointsComeInTheFrameOfTheJob) {
  const v1::FixedPointResult result =
      ResultOf(RunPlan(std::string(kStone) + "frame: FRAME_PAPER fixed_point {}"));
  // Six digits of the paper's frame are known.
  EXPECT_NEAR(result.cycles(0).points(0).l(), 3.650723, 1e-6);
  EXPECT_NEAR(result.cycles(0).points(0).l_over_g(), 0.669144, 1e-6);
}

TEST(FixedPointPlan, GuessThatDoesNotConvergeFailsWithTheReason) {
  const PlanRun run = RunPlan(
      std::string(kHenon) +
      "fixed_point { near { x: [3, 1, -2] } newton_iterations: 2 newton_tolerance: 1e-14 }");
  EXPECT_EQ(run.status.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(run.status.message()),
              ::testing::MatchesRegex("no cycle of period 1 found: no convergence in 2 iterations; "
                                      "residual [0-9.e-]+ after 2 iterations"));
}

TEST(FixedPointPlan, GuessThatIsLostFailsWithWhereItWas) {
  const PlanRun run =
      RunPlan(std::string(kStone) + "fixed_point { near { l: 1 l_over_g: 0.3 h_over_g: -0.99 } }");
  EXPECT_EQ(run.status.code(), absl::StatusCode::kOutOfRange);
  EXPECT_THAT(std::string(run.status.message()), HasSubstr("left the domain: "));
  EXPECT_THAT(std::string(run.status.message()), HasSubstr("gamma3"));
}

TEST(FixedPointPlan, ShorterCycleGoneRoundIsNoAnswer) {
  const PlanRun run = RunPlan(std::string(kHenon) + "fixed_point { period: 2 }");
  EXPECT_EQ(run.status.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(run.status.message()),
              HasSubstr("no cycle of period 2 found: Newton's method came to one of period 1, gone "
                        "round 2 times"));
}

TEST(CycleSearchPlan, FindsTheStonesFixedPointsWithTheirMirrorImages) {
  const PlanRun run = RunPlan(std::string(kStone) + "fixed_point { search: 24 }");
  const v1::FixedPointResult result = ResultOf(run);
  // O*, a saddle-focus, and their images under the reversal of time.
  ASSERT_THAT(result.cycles(), SizeIs(4));
  EXPECT_THAT(run.records, SizeIs(4));
  EXPECT_EQ(run.work, 24);
  int known = 0;
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(result.twins(i), 1);
    const v1::Cycle& cycle = result.cycles(i);
    const int mirror = result.mirrors(i);
    ASSERT_GE(mirror, 0);
    EXPECT_NE(mirror, i);
    EXPECT_EQ(result.mirrors(mirror), i);
    for (int k = 0; k < 3; ++k) {
      const double product =
          Modulus(cycle.multipliers(k)) * Modulus(result.cycles(mirror).multipliers(2 - k));
      EXPECT_NEAR(product, 1, kAsReference);
    }
    if (cycle.type() == "saddle 2-1") {
      EXPECT_NEAR(cycle.points(0).l(), 2.147462384985, kAsReference);
      ++known;
    }
    if (cycle.type() == "saddle-focus 1-2") {
      EXPECT_NEAR(cycle.points(0).l_over_g(), 0.5418546569, kAsReference);
      ++known;
    }
  }
  EXPECT_EQ(known, 2);
  EXPECT_EQ(result.accuracy().sample(), 4);
}

TEST(CycleSearchPlan, BoxIsTheSameInBothFrames) {
  const std::string box =
      "fixed_point { search: 12 lower { l: -1 l_over_g: -0.7 h_over_g: -0.5 } "
      "upper { l: 3 l_over_g: 0.2 h_over_g: 0.4 } }";
  // −(l + δ) and −L/G: the ends change places.
  const std::string turned =
      "frame: FRAME_PAPER fixed_point { search: 12 lower { l: -3.485 l_over_g: -0.2 h_over_g: -0.5 "
      "} upper { l: 0.515 l_over_g: 0.7 h_over_g: 0.4 } }";
  const v1::FixedPointResult body = ResultOf(RunPlan(std::string(kStone) + box));
  const v1::FixedPointResult paper = ResultOf(RunPlan(std::string(kStone) + turned));
  EXPECT_EQ(Serialize(body.tally()), Serialize(paper.tally()));
  EXPECT_THAT(body.hits(), ::testing::ElementsAreArray(paper.hits()));
  EXPECT_GT(body.tally().found(), 0);
}

TEST(CycleSearchPlan, TallyAddsUpAndRecordsComeInTheOrderOfTheirStarts) {
  const PlanRun run = RunPlan(
      std::string("system { name: 'henon3d' parameters { key: 'm1' value: 3 } parameters { key: "
                  "'m2' value: 0.05 } parameters { key: 'b' value: 0.05 } } ") +
      "fixed_point { period: 4 search: 300 lower { x: [-2, -2, -2] } upper { x: [2, 2, 2] } }");
  const v1::FixedPointResult result = ResultOf(run);
  EXPECT_THAT(result.cycles(), SizeIs(3)) << "as many as the logistic map has nearby";
  const v1::SearchTally& tally = result.tally();
  EXPECT_EQ(tally.starts(), 300);
  EXPECT_EQ(tally.found() + tally.shorter() + tally.no_convergence() + tally.left_domain() +
                tally.singular() + tally.outside(),
            300);
  EXPECT_EQ(result.hits(0) + result.hits(1) + result.hits(2), tally.found());
  EXPECT_GT(tally.shorter(), 0);
  std::int64_t before = -1;
  for (const v1::Record& record : run.records) {
    EXPECT_GT(record.fixed_point().first_start(), before);
    before = record.fixed_point().first_start();
  }
}

TEST(CycleSearchPlan, SameBytesHoweverInterruptedAndWhateverTheThreads) {
  const v1::JobSpec spec = Resolved(std::string(kStone) + "fixed_point { search: 20 }");
  for (const int workers : {1, 2}) ExpectSameBytesWhenInterrupted(spec, workers, 1);
}

TEST(CycleSearchPlan, StopsBetweenTwoStarts) {
  const auto plan =
      MakeFixedPointPlan(Resolved(std::string(kHenon) + "fixed_point { search: 1000000 }"));
  int asked = 0;
  const auto output = (*plan)->Run({0, 0}, "", [&] { return ++asked > 10; });
  EXPECT_TRUE(absl::IsCancelled(output.status())) << output.status();
  EXPECT_EQ(asked, 11);
}

TEST(FixedPointSpec, FillsInEveryDefault) {
  const v1::JobSpec spec = Resolved("fixed_point {}");
  EXPECT_EQ(spec.fixed_point().period(), 1);
  EXPECT_TRUE(spec.fixed_point().near().has_l());
  EXPECT_EQ(spec.fixed_point().newton_tolerance(), 1e-10);
  EXPECT_EQ(spec.fixed_point().newton_iterations(), 50);
  EXPECT_EQ(spec.numerics().tolerance(), 1e-13) << "multipliers to 1e-9 need it";
  const v1::FixedPointSpec search = Resolved("fixed_point { search: 5 }").fixed_point();
  EXPECT_FALSE(search.has_near());
  EXPECT_EQ(search.seed(), 1U);
  EXPECT_EQ(search.lower().l_over_g(), -1);
  EXPECT_EQ(search.upper().l(), 2 * std::numbers::pi);
}

TEST(FixedPointSpec, ResolvingTwiceChangesNothing) {
  for (const char* text : {"fixed_point {}", "fixed_point { search: 5 }",
                           "frame: FRAME_PAPER fixed_point { search: 5 }",
                           "system { name: 'henon3d' } fixed_point { search: 5 }"}) {
    const v1::JobSpec once = Resolved(text);
    EXPECT_EQ(Serialize(*ResolveSpec(once)), Serialize(once)) << text;
  }
}

TEST(FixedPointSpec, RefusesWhatMakesNoSense) {
  for (const BadSpecification& bad : {
           BadSpecification{"fixed_point { period: 0 }", "period:", "0 is not allowed"},
           BadSpecification{"fixed_point { period: 257 }", "period:", "[1, 256]"},
           BadSpecification{"fixed_point { search: 0 }", "search:", "[1, 10000000]"},
           BadSpecification{"fixed_point { search: 5 near { l: 1 } }", "near:", "search"},
           BadSpecification{"fixed_point { seed: 5 }", "seed:", "search"},
           BadSpecification{"fixed_point { upper { l: 1 } }", "upper:", "search"},
           BadSpecification{"fixed_point { near { l: 1 l_over_g: 0.5 } }", "near:", "h_over_g"},
           BadSpecification{"fixed_point { near { l: 1 l_over_g: 2 h_over_g: 0 } }", "near:", "2"},
           BadSpecification{"fixed_point { newton_tolerance: 0 }", "newton_tolerance:", "(0, 1]"},
           BadSpecification{"fixed_point { newton_tolerance: nan }", "newton_tolerance:", "nan"},
           BadSpecification{"fixed_point { newton_iterations: 0 }", "newton_iterations:", "0"},
           BadSpecification{"fixed_point { search: 5 lower { l: 1 l_over_g: 0 h_over_g: -3 } }",
                            "lower: h_over_g:", "[-1, 1]"},
           BadSpecification{"fixed_point { search: 5 lower { l: 7 l_over_g: 0 h_over_g: 0 } }",
                            "upper: l:", "7 of lower"},
           BadSpecification{"fixed_point { search: 5 upper { x: 7 } }", "upper:", "l_over_g"},
       }) {
    ExpectRefused(bad);
  }
}

}  // namespace
}  // namespace celt::plans
