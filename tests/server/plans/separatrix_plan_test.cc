#include "server/plans/separatrix_plan.h"

#include <cmath>
#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "plans/plan_testing.h"
#include "server/plans/separatrix_state.h"

namespace celt::plans {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

std::string Stone(const std::string& separatrix, const std::string& before = "") {
  return "numerics { engine: ENGINE_FAST tolerance: 1e-11 } " + before + " separatrix { " +
         separatrix + " }";
}

v1::SeparatrixResult ResultOf(const PlanRun& run) {
  EXPECT_TRUE(run.status.ok()) << run.status;
  return run.result.separatrix();
}

TEST(SeparatrixPlan, FindsTheButterfly) {
  const PlanRun run = RunPlan(Stone("from: 748.439 to: 748.44 width: 1e-6"));
  const v1::SeparatrixResult result = ResultOf(run);
  // tests/reference/celtic_stone.json.
  EXPECT_NEAR(result.value(), 748.4394655, 1e-6);
  EXPECT_LE(result.error(), 0.5e-6);
  EXPECT_LT(result.yes(), result.no());
  EXPECT_EQ(result.yes_fate().changes(), 0);
  EXPECT_GT(result.no_fate().changes(), 0);
  EXPECT_NEAR(result.saddle().l(), 2.1439, 1e-3);
  EXPECT_EQ(result.accuracy().sample(), 1);
  // Two ends, and ten halvings from 1e-3 to below 1e-6.
  EXPECT_THAT(run.records, SizeIs(12));
  EXPECT_EQ(run.units, 12);
  EXPECT_EQ(run.work, 12);
}

TEST(SeparatrixPlan, FindsWhereItLeavesTheBasin) {
  const v1::SeparatrixResult result = ResultOf(
      RunPlan(Stone("question: SEPARATRIX_QUESTION_TENDS from: 748.93 to: 748.98 width: 3e-3")));
  EXPECT_NEAR(result.value(), 748.951, 2e-3 + result.error());
  EXPECT_EQ(result.yes_fate().end(), "tends to a cycle");
}

TEST(SeparatrixPlan, UndecidedEndWarns) {
  const v1::SeparatrixResult result =
      ResultOf(RunPlan(Stone("question: SEPARATRIX_QUESTION_TENDS from: 748.4 to: 748.8 width: 0.4 "
                             "most_iterates: 700")));
  EXPECT_EQ(result.no_fate().end(), "undecided");
  ASSERT_THAT(result.accuracy().warnings(), SizeIs(1));
  EXPECT_THAT(result.accuracy().warnings(0), HasSubstr("748.8 is undecided after 700 iterates"));
}

TEST(SeparatrixPlan, RecordsAreTheValuesLookedAt) {
  const PlanRun run = RunPlan(Stone("from: 748.4 to: 748.5 width: 0.06"));
  ASSERT_THAT(run.records, SizeIs(3));
  const double values[] = {748.4, 748.5, 748.45};
  for (int i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(run.records[i].separatrix().value(), values[i]);
    EXPECT_EQ(run.records[i].separatrix().answer(), i == 0);
    EXPECT_EQ(run.records[i].separatrix().fate().iterates() % 2, 0) << "of the map";
  }
}

TEST(SeparatrixPlan, OtherSideIsThatOfTheTwin) {
  // F takes one separatrix to the other.
  const PlanRun run = RunPlan(Stone("from: 748.4 to: 748.5 width: 0.06 side: -1"));
  EXPECT_EQ(ResultOf(run).yes_fate().side(), -1);
}

TEST(SeparatrixPlan, EndsThatAgreeFailWithBothFatesAndKeepTheirRecords) {
  const PlanRun run = RunPlan(Stone("from: 748.4 to: 748.41"));
  EXPECT_EQ(run.status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(run.status.message()),
              HasSubstr("does the same at both ends, 748.4 (tends to a cycle, 0 changes of side)"));
  EXPECT_THAT(run.records, SizeIs(2));
}

TEST(SeparatrixPlan, CycleThatIsNoSaddleFailsWithItsMultipliers) {
  const PlanRun run = RunPlan(Stone("from: 747 to: 748.5"));
  EXPECT_EQ(run.status.code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(run.status.message()), HasSubstr("has 0 multipliers outside"));
}

TEST(SeparatrixPlan, GuessThatDoesNotConvergeFailsWithTheReason) {
  const PlanRun run =
      RunPlan(Stone("from: 748.4 to: 748.5 near { l: 1 l_over_g: 0.3 h_over_g: 0.2 }"));
  EXPECT_EQ(run.status.code(), absl::StatusCode::kNotFound);
  EXPECT_THAT(std::string(run.status.message()),
              HasSubstr("no cycle of period 1 found at 748.4: "));
  EXPECT_THAT(std::string(run.status.message()), HasSubstr("; residual "));
}

TEST(SeparatrixPlan, SameBytesHoweverInterrupted) {
  const v1::JobSpec spec = Resolved(Stone("from: 748.4 to: 748.5 width: 2e-2"));
  for (const std::int64_t after : {1, 3}) ExpectSameBytesWhenInterrupted(spec, 2, after);
}

TEST(SeparatrixPlan, StopsInsideAUnit) {
  const auto plan = MakeSeparatrixPlan(Resolved(Stone("from: 748.4 to: 748.5")));
  int asked = 0;
  const auto output = (*plan)->Run({0, 0}, "", [&] { return ++asked > 10; });
  EXPECT_TRUE(absl::IsCancelled(output.status())) << output.status();
  EXPECT_EQ(asked, 11);
}

TEST(SeparatrixState, ComesBackToTheLastBit) {
  SeparatrixBisection bisection;
  SeparatrixProbe probe;
  probe.value = 1.0 / 3;
  probe.saddle = Eigen::Vector3d(1.0 / 7, -0.0, 1e-310);
  probe.iterates = 2;
  probe.answer = true;
  probe.fate.end = SeparatrixEnd::kLost;
  probe.fate.side = -1;
  probe.fate.changes = 1;
  probe.fate.iterates = 12345678901;
  probe.fate.point = Eigen::Vector3d(1, 2, 3);
  probe.fate.message = "lost";
  bisection.ends = {probe, probe};
  bisection.last = probe;
  bisection.done = true;
  const std::string bytes = EncodeBisection(bisection);
  const auto back = DecodeBisection(bytes);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_EQ(EncodeBisection(*back), bytes);
  ASSERT_THAT(back->ends, SizeIs(2));
  EXPECT_EQ(back->last.saddle, probe.saddle);
  EXPECT_TRUE(std::signbit(back->last.saddle[1]));
  EXPECT_EQ(back->ends[1].fate.iterates, 12345678901);
  EXPECT_TRUE(absl::IsDataLoss(DecodeBisection("nonsense").status()));
}

TEST(SeparatrixSpec, FillsInEveryDefault) {
  const v1::SeparatrixSpec spec = Resolved("separatrix { from: 748.4 to: 748.5 }").separatrix();
  EXPECT_EQ(spec.parameter(), "energy");
  EXPECT_EQ(spec.question(), v1::SEPARATRIX_QUESTION_RETURNS);
  EXPECT_EQ(spec.width(), 1e-7);
  EXPECT_EQ(spec.side(), 1);
  EXPECT_EQ(spec.most_iterates(), 20000);
  EXPECT_TRUE(spec.near().has_l());
  const v1::SeparatrixSpec tends =
      Resolved("separatrix { from: 748.4 to: 748.5 question: SEPARATRIX_QUESTION_TENDS }")
          .separatrix();
  EXPECT_EQ(tends.width(), 1e-3);
}

TEST(SeparatrixSpec, RefusesWhatMakesNoSense) {
  for (const BadSpecification& bad : {
           BadSpecification{"separatrix { to: 748 }", "from:", "missing"},
           BadSpecification{"separatrix { from: 748 }", "to:", "missing"},
           BadSpecification{"separatrix { from: 748 to: 748 }", "to:", "other than from"},
           BadSpecification{"separatrix { from: 748 to: 749 width: 0 }", "width:", "0"},
           BadSpecification{"separatrix { from: 748 to: 749 width: nan }", "width:", "nan"},
           BadSpecification{"separatrix { from: 748 to: 749 side: 2 }", "side:", "1 or -1"},
           BadSpecification{"separatrix { from: 748 to: 749 period: 0 }", "period:", "[1, 256]"},
           BadSpecification{"separatrix { from: 748 to: 749 most_iterates: 0 }",
                            "most_iterates:", "[1, 10000000]"},
           BadSpecification{"separatrix { from: 748 to: 749 near { l: 1 } }", "near:", "l_over_g"},
           BadSpecification{"separatrix { from: 748 to: 749 parameter: 'x' }", "parameter:", "'x'"},
       }) {
    ExpectRefused(bad);
  }
}

}  // namespace
}  // namespace celt::plans
