#include "server/plans/hyperbolicity_plan.h"

#include <cmath>

#include "core/analysis/hyperbolicity.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "plans/plan_testing.h"
#include "server/plans/hyperbolicity_spec.h"
#include "server/plans/hyperbolicity_state.h"

namespace celt::plans {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string Henon(double m2, const std::string& hyperbolicity) {
  return "system { name: 'henon3d' parameters { key: 'm2' value: " + std::to_string(m2) +
         " } } hyperbolicity { " + hyperbolicity + " }";
}

TEST(HyperbolicityPlan, HenonMapAtM2Of0815IsPseudoHyperbolic) {
  const PlanRun run = RunPlan(Henon(0.815, "iterates: 100000 scout: 20000"));
  ASSERT_TRUE(run.status.ok()) << run.status;
  const v1::HyperbolicityResult& result = run.result.hyperbolicity();
  EXPECT_EQ(result.verdict(), v1::PSEUDO_HYPERBOLIC);
  ASSERT_THAT(result.tests(), SizeIs(5));
  for (const v1::HyperbolicityTest& test : result.tests()) {
    EXPECT_EQ(test.outcome(), "passed") << test.why();
    EXPECT_GT(test.margin(), 0) << test.name();
  }
  // The reference, 0.454, is of an orbit of its own: minima of eighths scatter by 0.0013.
  EXPECT_NEAR(result.minimum_angle(), 0.454, 0.003);
  ASSERT_THAT(result.conditions(), SizeIs(4));
  for (const v1::Condition& condition : result.conditions()) EXPECT_TRUE(condition.holds());
  EXPECT_EQ(result.samples(), 100'000 - 300);
  EXPECT_EQ(run.work, 122'000);
  EXPECT_EQ(result.accuracy().map_error(), 0) << "a formula";
}

TEST(HyperbolicityPlan, HenonMapAtM2Of085HasTangenciesThoughTheConditionsHold) {
  const v1::HyperbolicityResult result =
      RunPlan(Henon(0.85, "iterates: 60000")).result.hyperbolicity();
  EXPECT_EQ(result.verdict(), v1::TANGENCIES);
  for (const v1::Condition& condition : result.conditions()) EXPECT_TRUE(condition.holds());
  EXPECT_LT(result.minimum_angle(), 0.005);
  EXPECT_LT(result.minimum_by_length(3), result.minimum_by_length(0));
}

TEST(HyperbolicityPlan, StoneIsMeasuredWithItsAccuracy) {
  const PlanRun run = RunPlan(
      "numerics { engine: ENGINE_FAST } "
      "hyperbolicity { iterates: 2500 transient: 500 scout: 500 }");
  ASSERT_TRUE(run.status.ok()) << run.status;
  const v1::HyperbolicityResult& result = run.result.hyperbolicity();
  EXPECT_GT(result.accuracy().map_error(), 0);
  EXPECT_LT(result.accuracy().map_error(), 1e-10);
  EXPECT_GE(result.accuracy().sample(), 15);
  // Half of what Lambda1 is at 752, and twice of it, for so short an orbit.
  EXPECT_GT(result.exponents_per_iterate(0), 0.01);
  EXPECT_LT(result.exponents_per_iterate(0), 0.04);
  EXPECT_TRUE(result.minimum_point().has_l());
}

TEST(HyperbolicityPlan, AnswersAsTheWholeOrbitInOneCall) {
  const v1::JobSpec spec = Resolved(Henon(0.815, "iterates: 50000 transient: 100 scout: 1000"));
  const PlanRun cut = RunPlan(spec);
  EXPECT_EQ(cut.units, 4);
  const auto map = MakeMap(spec);
  HyperbolicityRun whole;
  whole.transient = 100;
  whole.scout = 1000;
  whole.iterates = 50'000;
  const auto report =
      MeasureHyperbolicity(**map, DrawStarts(Point::Constant(3, 0.1), Point::Zero(3), 1, 1).front(),
                           whole, [](std::int64_t) { return true; });
  ASSERT_TRUE(report.ok()) << report.status();
  EXPECT_EQ(cut.result.hyperbolicity().minimum_angle(), report->minimum.angle);
  EXPECT_EQ(cut.result.hyperbolicity().tail_index(), report->tail.index);
  ASSERT_THAT(cut.records, SizeIs(2));
  EXPECT_EQ(cut.records[0].hyperbolicity().iterates(), 40'000);
  EXPECT_EQ(cut.records[1].hyperbolicity().iterates(), 50'000);
  EXPECT_EQ(cut.records[1].hyperbolicity().minimum_angle(), report->minimum.angle);
  EXPECT_EQ(cut.records[1].hyperbolicity().exponents_per_iterate(0),
            cut.result.hyperbolicity().exponents_per_iterate(0));
}

TEST(HyperbolicityPlan, SameBytesHoweverInterrupted) {
  ExpectSameBytesWhenInterrupted(Resolved(Henon(0.815, "iterates: 50000")), 2, 1);
}

TEST(HyperbolicityPlan, RegularAttractorIsUndecided) {
  // The fixed point 0 attracts for m2 = 0.1, b = 0.5: all of its whitened orbit is one point.
  const PlanRun run = RunPlan(
      "system { name: 'henon3d' parameters { key: 'm2' value: 0.1 } parameters { key: 'b' value: "
      "0.5 } } hyperbolicity { iterates: 4000 }");
  ASSERT_TRUE(run.status.ok()) << run.status;
  EXPECT_EQ(run.result.hyperbolicity().verdict(), v1::UNDECIDED);
  EXPECT_EQ(run.result.ShortDebugString().find("nan"), std::string::npos);
  EXPECT_EQ(run.result.ShortDebugString().find("inf"), std::string::npos);
}

TEST(HyperbolicityPlan, LostOrbitSaysWhy) {
  const PlanRun run =
      RunPlan("system { name: 'henon3d' } hyperbolicity { start { x: [50, 50, 50] } }");
  EXPECT_EQ(run.status.code(), absl::StatusCode::kOutOfRange);
  EXPECT_THAT(std::string(run.status.message()), HasSubstr("escapes"));
}

TEST(HyperbolicityPlan, LosesNothingButTheUnitInWhichItStops) {
  const auto plan = MakeHyperbolicityPlan(Resolved(Henon(0.815, "")));
  int asked = 0;
  const auto output = (*plan)->Run({0, 0}, "", [&] { return ++asked > 10; });
  EXPECT_TRUE(absl::IsCancelled(output.status())) << output.status();
  EXPECT_LT(asked, 20);
}

TEST(HyperbolicityState, ComesBackToTheLastBit) {
  const auto map = MakeMap(Resolved(Henon(0.815, "")));
  HyperbolicityWork work;
  work.splitting.orbit = DrawStarts(Point::Constant(3, 0.1), Point::Zero(3), 1, 7).front();
  const auto go_on = [](std::int64_t) { return true; };
  ASSERT_TRUE(AdvanceCovariance(**map, work.splitting.orbit, 500, go_on, work.covariance).ok());
  const HyperbolicityOptions options;
  const Whitening whitening = WhiteningOf(work.covariance);
  const auto advance = [&](HyperbolicityWork& at) {
    const auto stretch = AdvanceSplitting(**map, at.splitting, 1500, options.settle, go_on);
    AddStretch(**map, whitening, options, *stretch, at.sums);
    at.sample.push_back(at.splitting.orbit.point);
  };
  advance(work);
  auto again = DecodeHyperbolicity(EncodeHyperbolicity(work), 3);
  ASSERT_TRUE(again.ok()) << again.status();
  EXPECT_EQ(EncodeHyperbolicity(*again), EncodeHyperbolicity(work));
  EXPECT_EQ(WhiteningOf(again->covariance).matrix, whitening.matrix);
  // It goes on as if nothing had happened.
  advance(work);
  advance(*again);
  EXPECT_EQ(EncodeHyperbolicity(*again), EncodeHyperbolicity(work));
  EXPECT_EQ(again->sums.angles.Quantile(0.5), work.sums.angles.Quantile(0.5));
  EXPECT_FALSE(DecodeHyperbolicity(EncodeHyperbolicity(work), 4).ok());
  EXPECT_FALSE(DecodeHyperbolicity("nonsense", 3).ok());
}

TEST(HyperbolicitySpec, FillsInEveryDefault) {
  const v1::HyperbolicitySpec spec = Resolved("hyperbolicity {}").hyperbolicity();
  EXPECT_EQ(spec.iterates(), 20'000);
  EXPECT_EQ(spec.transient(), 2000);
  EXPECT_EQ(spec.scout(), 5000);
  EXPECT_EQ(spec.seed(), 1U);
  EXPECT_TRUE(spec.start().has_l());
}

TEST(HyperbolicitySpec, KeepsABoundedNumberOfPoints) {
  v1::HyperbolicitySpec spec;
  for (const std::int64_t iterates : {1900, 100'000, 100'001, 100'000'000}) {
    spec.set_iterates(iterates);
    const std::int64_t kept = iterates / HyperbolicityOptionsOf(spec).lmp_stride;
    EXPECT_LE(kept, 100'000);
    EXPECT_GE(kept, std::min<std::int64_t>(iterates, 50'000));
  }
}

TEST(HyperbolicitySpec, RefusesWhatMakesNoSense) {
  for (const BadSpecification& bad : {
           BadSpecification{"hyperbolicity { iterates: 0 }", "iterates:", "[1900, 100000000]"},
           BadSpecification{"hyperbolicity { iterates: 1000000000000 }", "iterates:", "[1900, "},
           BadSpecification{"hyperbolicity { transient: -1 }", "transient:", "-1"},
           BadSpecification{"hyperbolicity { scout: 99 }", "scout:", "[100, "},
           BadSpecification{"hyperbolicity { start { l: 1 l_over_g: 0 h_over_g: -1 } }",
                            "start:", "-1"},
       }) {
    ExpectRefused(bad);
  }
}

}  // namespace
}  // namespace celt::plans
