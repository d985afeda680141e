#include "server/plans/section_plan.h"

#include <cmath>
#include <numbers>

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

v1::SectionRecord At(const PlanRun& run, std::size_t i) { return run.records.at(i).section(); }

TEST(SectionPlan, RecordsTheStartAndThenEveryIterate) {
  const PlanRun run =
      RunPlan(std::string(kHenon) + "section { iterates: 3 start { x: [1, 0.5, 2] } }");
  ASSERT_THAT(run.records, SizeIs(4));
  EXPECT_THAT(At(run, 0).point().x(), ElementsAre(1, 0.5, 2));
  EXPECT_FALSE(At(run, 0).has_return_time());
  // z' = m1 + b x + m2 y + a z - z^2 with 0, 0.7, 0.85, 0.
  EXPECT_THAT(At(run, 1).point().x(), ElementsAre(0.5, 2, 0.7 + 0.85 * 0.5 - 4));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(At(run, i).iterate(), i);
    EXPECT_EQ(At(run, i).time(), i) << "a map that is no section of a flow";
  }
  EXPECT_EQ(run.work, 3);
}

TEST(SectionPlan, ResultIsTheOrbitAsAWhole) {
  const PlanRun run = RunPlan(std::string(kHenon) + "section { iterates: 9000 transient: 5000 }");
  const v1::SectionResult& result = run.result.section();
  EXPECT_EQ(result.iterates(), 14000);
  EXPECT_EQ(result.mean_return_time(), 1);
  ASSERT_THAT(run.records, SizeIs(9000));
  EXPECT_EQ(At(run, 0).iterate(), 5001);
  EXPECT_EQ(At(run, 8999).iterate(), 14000);
  EXPECT_EQ(At(run, 8999).point().x(2), result.last().x(2));
  double lowest = INFINITY;
  double highest = -INFINITY;
  for (const v1::Record& record : run.records) {
    lowest = std::min(lowest, record.section().point().x(2));
    highest = std::max(highest, record.section().point().x(2));
  }
  EXPECT_EQ(result.lowest(2), lowest);
  EXPECT_EQ(result.highest(2), highest);
  EXPECT_EQ(run.work, 14000);
}

TEST(SectionPlan, TransientIsTheBeginningOfTheSameOrbit) {
  const PlanRun all = RunPlan(std::string(kStone) + "section { iterates: 12 }");
  const PlanRun tail = RunPlan(std::string(kStone) + "section { iterates: 5 transient: 7 }");
  ASSERT_THAT(tail.bytes, SizeIs(5));
  for (int i = 0; i < 5; ++i) EXPECT_EQ(tail.bytes[i], all.bytes[8 + i]);
}

TEST(SectionPlan, StaysAtTheFixedPointOfTheStone) {
  // O* at 752 is given to 1e-12 and the map errs by 5e-13 an iterate, both of which the next, with
  // a Jacobian of size 30, makes larger.
  const PlanRun run =
      RunPlan("numerics { engine: ENGINE_FAST tolerance: 1e-13 } section { iterates: 5 }");
  EXPECT_NEAR(At(run, 5).point().l(), 2.147462384985, 1e-10);
  EXPECT_NEAR(run.result.section().mean_return_time(), 0.792136027186, 1e-10);
  const PlanRun paper = RunPlan(std::string(kStone) + "frame: FRAME_PAPER section { iterates: 5 }");
  EXPECT_NEAR(At(paper, 5).point().l(), 3.650723, 1e-6);
}

TEST(SectionPlan, MeasuresItsAccuracyOnPointsOfTheOrbit) {
  const v1::Accuracy accuracy =
      RunPlan(std::string(kStone) + "section { iterates: 100 }").result.section().accuracy();
  EXPECT_EQ(accuracy.sample(), 16);
  // 1.9e-11 is the most that was found on the attractor at the default tolerance.
  EXPECT_GT(accuracy.map_error(), 1e-13);
  EXPECT_LT(accuracy.map_error(), 1e-10);
}

TEST(SectionPlan, BackwardGoesBackToTheStart) {
  const PlanRun there =
      RunPlan(std::string(kStone) +
              "section { iterates: 3 start { l: 2.15 l_over_g: -0.67 h_over_g: -0.385 } }");
  const v1::Point last = there.result.section().last();
  v1::JobSpec spec =
      ParseSpec(std::string(kStone) + "section { iterates: 3 direction: DIRECTION_BACKWARD }");
  *spec.mutable_section()->mutable_start() = last;
  const PlanRun back = RunPlan(*ResolveSpec(spec));
  EXPECT_EQ(At(back, 3).iterate(), -3);
  EXPECT_NEAR(At(back, 3).time(), -At(there, 3).time(), 1e-9);
  EXPECT_GT(At(back, 3).return_time(), 0);
  // Three maps each way, 5e-11 each, and the inverse stretches by 6.
  EXPECT_NEAR(back.result.section().last().l(), 2.15, 1e-8);
}

TEST(SectionPlan, AnglesOfTheRangeLieInATurn) {
  const PlanRun run = RunPlan(std::string(kStone) +
                              "section { iterates: 1 start { l: -4.135722922194586 l_over_g: "
                              "-0.669144118368 h_over_g: -0.384701258034 } }");
  const v1::SectionResult& result = run.result.section();
  EXPECT_NEAR(result.lowest(0), 2.147462384985, 1e-9);
  EXPECT_NEAR(result.highest(0), 2.147462384985, 1e-9);
}

TEST(SectionPlan, SameBytesHoweverInterrupted) {
  const v1::JobSpec spec =
      Resolved(std::string(kHenon) + "section { iterates: 20001 transient: 3 }");
  for (const int workers : {1, 2}) ExpectSameBytesWhenInterrupted(spec, workers, 4000);
}

TEST(SectionPlan, KeepsItsStateSmallAndItsUnitsShort) {
  const PlanRun run = RunPlan(std::string(kHenon) + "section { iterates: 20000 }");
  EXPECT_LT(run.largest_checkpoint, 512U);
  EXPECT_GE(run.units, 4);
}

TEST(SectionPlan, LostOrbitKeepsItsRecordsAndSaysWhy) {
  // Far from the attractor the map's quadratic term sends every orbit to infinity.
  const PlanRun run = RunPlan(std::string(kHenon) + "section { start { x: [50, 50, 50] } }");
  EXPECT_EQ(run.status.code(), absl::StatusCode::kOutOfRange);
  EXPECT_THAT(std::string(run.status.message()), HasSubstr("after 1 iterates: the orbit escapes"));
  EXPECT_THAT(run.records, SizeIs(2));
}

TEST(SectionPlan, StopsInsideAUnit) {
  const auto plan = MakeSectionPlan(Resolved(std::string(kHenon) + "section {}"));
  int asked = 0;
  const auto output = (*plan)->Run({0, 0}, "", [&] { return ++asked > 10; });
  EXPECT_TRUE(absl::IsCancelled(output.status())) << output.status();
  EXPECT_EQ(asked, 11);
}

TEST(SectionSpec, FillsInEveryDefault) {
  const v1::SectionSpec spec = Resolved("section {}").section();
  EXPECT_EQ(spec.iterates(), 1000);
  EXPECT_EQ(spec.transient(), 0);
  EXPECT_TRUE(spec.has_transient());
  EXPECT_EQ(spec.direction(), v1::DIRECTION_FORWARD);
  EXPECT_TRUE(spec.start().has_l());
}

TEST(SectionSpec, RefusesWhatMakesNoSense) {
  for (const BadSpecification& bad : {
           BadSpecification{"section { iterates: 0 }", "iterates:", "0 is not allowed"},
           BadSpecification{"section { iterates: 1000000000000 }", "iterates:", "[1, 1000000000]"},
           BadSpecification{"section { transient: -1 }", "transient:", "-1"},
           BadSpecification{"section { start { l: 1 l_over_g: -1 h_over_g: 0 } }", "start:", "-1"},
           BadSpecification{"section { start { l: nan l_over_g: 0 h_over_g: 0 } }",
                            "start:", "nan"},
           BadSpecification{"section { start { x: 1 } }", "start:", "l_over_g"},
       }) {
    ExpectRefused(bad);
  }
  v1::JobSpec spec = ParseSpec("section {}");
  spec.mutable_section()->set_direction(static_cast<v1::Direction>(77));
  EXPECT_THAT(std::string(ResolveSpec(spec).status().message()), HasSubstr("direction: 77"));
}

}  // namespace
}  // namespace celt::plans
