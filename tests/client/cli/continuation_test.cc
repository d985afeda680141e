#include "client/cli/continuation.h"

#include "client/cli/continuation_table.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt::cli {
namespace {

v1::Cycle Cycle() {
  v1::Cycle cycle;
  cycle.set_period(1);
  for (const double x : {0.5, 0.25}) {
    if (cycle.points().empty()) cycle.add_points();
    cycle.mutable_points(0)->add_x(x);
  }
  cycle.set_return_time(1);
  cycle.add_multipliers()->set_re(0.25);
  cycle.mutable_multipliers(0)->set_im(0.5);
  cycle.add_multipliers()->set_re(0.25);
  cycle.mutable_multipliers(1)->set_im(-0.5);
  cycle.set_type("stable focus");
  return cycle;
}

v1::Record PointRecord() {
  v1::Record record;
  record.set_sequence(1);
  v1::BranchPoint& point = *record.mutable_continuation()->mutable_point();
  point.set_branch(0);
  point.set_value(752);
  point.set_arclength(0.125);
  *point.mutable_cycle() = Cycle();
  return record;
}

v1::Record TorusRecord() {
  v1::Record record;
  record.set_sequence(2);
  v1::Bifurcation& torus = *record.mutable_continuation()->mutable_bifurcation();
  torus.set_type(v1::NEIMARK_SACKER);
  torus.set_value(748.5);
  torus.set_value_error(2e-11);
  *torus.mutable_cycle() = Cycle();
  *torus.add_critical() = Cycle().multipliers(0);
  torus.set_angle(1.5625);
  torus.set_resonance("1:4");
  torus.set_coefficient(-0.5);
  torus.set_coefficient_error(0.001);
  torus.set_criticality("supercritical");
  torus.set_branch(0);
  return record;
}

v1::ContinuationResult Result() {
  v1::ContinuationResult result;
  *result.add_branch() = PointRecord().continuation().point();
  *result.add_bifurcations() = TorusRecord().continuation().bifurcation();
  v1::BranchSummary& branch = *result.add_branches();
  branch.set_branch(0);
  branch.set_period(1);
  branch.set_points(53);
  branch.set_from(752);
  branch.set_to(747.25);
  branch.set_end("left the domain");
  branch.set_message("gamma3 goes to 0");
  result.mutable_accuracy()->set_map_error(1.5e-13);
  result.mutable_accuracy()->set_jacobian_error(5e-13);
  return result;
}

TEST(Continuation, SendsWhatWasGiven) {
  FakeService service;
  v1::StreamResultsResponse answer;
  *answer.mutable_result()->mutable_continuation() = Result();
  service.scripts = {{{answer}, {}}};
  const Outcome outcome =
      RunCelt({"continue", "--parameter", "delta", "--from", "0.5", "--to", "0.25", "--period", "2",
               "--near", "2.1,-0.6,-0.4", "--longest-step", "0.1", "--most-points", "99",
               "--doublings", "3"},
              {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const v1::ContinuationSpec spec = service.submitted().continuation();
  EXPECT_EQ(spec.parameter(), "delta");
  EXPECT_EQ(spec.from(), 0.5);
  EXPECT_EQ(spec.to(), 0.25);
  EXPECT_EQ(spec.period(), 2);
  EXPECT_EQ(spec.near().h_over_g(), -0.4);
  EXPECT_EQ(spec.longest_step(), 0.1);
  EXPECT_EQ(spec.most_points(), 99);
  EXPECT_EQ(spec.doublings(), 3);
  EXPECT_THAT(outcome.out, ::testing::HasSubstr(R"("type":"NEIMARK_SACKER","value":748.5)"));
}

TEST(Continuation, SaysNothingThatWasNotGiven) {
  v1::JobSpec spec;
  ASSERT_TRUE(MakeContinuation()->Fill(spec).ok());
  EXPECT_TRUE(spec.has_continuation());
  EXPECT_EQ(spec.continuation().ByteSizeLong(), 0U);
}

TEST(Continuation, CsvOfAPointAndOfABifurcationShareTheirColumns) {
  const CsvRow point = MakeContinuation()->Csv(PointRecord());
  const CsvRow torus = MakeContinuation()->Csv(TorusRecord());
  ASSERT_EQ(point.size(), torus.size());
  for (std::size_t i = 0; i < point.size(); ++i) EXPECT_EQ(point[i].first, torus[i].first);
  const CsvRow beginning = {{"branch", "0"},
                            {"bifurcation", "NEIMARK_SACKER"},
                            {"value", "748.5"},
                            {"value_error", "2e-11"},
                            {"arclength", ""},
                            {"angle", "1.5625"},
                            {"coefficient", "-0.5"},
                            {"coefficient_error", "0.001"},
                            {"criticality", "supercritical"}};
  EXPECT_EQ(CsvRow(torus.begin(), torus.begin() + std::ssize(beginning)), beginning);
  EXPECT_EQ(point[1].second, "");
  EXPECT_EQ(point[4].second, "0.125");
  EXPECT_TRUE(MakeContinuation()->Csv(v1::Result()).empty());
}

TEST(ContinuationTable, LinesShowWhatComes) {
  EXPECT_EQ(ContinuationLine(PointRecord()),
            "  branch         parameter  type               multipliers\n"
            "       0    752.0000000000  stable focus       0.250000 ± 0.500000 i\n");
  EXPECT_EQ(ContinuationLine(TorusRecord()),
            "       0    748.5000000000  NEIMARK_SACKER multiplier 0.250000 ± 0.500000 i, angle "
            "1.562500, strong resonance 1:4, supercritical, coefficient -0.5000 ± 0.0010\n");
}

TEST(ContinuationTable, SumsUp) {
  v1::JobSpec spec;
  spec.mutable_system()->set_name("celtic-stone");
  spec.mutable_continuation()->set_parameter("energy");
  spec.mutable_continuation()->set_period(1);
  spec.mutable_continuation()->set_from(752);
  spec.mutable_continuation()->set_to(747);
  EXPECT_EQ(ContinuationTable(spec, Result()), R"(
Branch of fixed points of celtic-stone, energy from 752 to 747

  bifurcation     energy                  branch
  NEIMARK_SACKER  748.5000000000 ± 2e-11  0       multiplier 0.250000 ± 0.500000 i, angle 1.562500, strong resonance 1:4, supercritical, coefficient -0.5000 ± 0.0010

  branch  period  points  energy from  to      end
  0       1       53      752          747.25  left the domain: gamma3 goes to 0

  map error 1.5e-13, of its derivative 5e-13
)");
}

TEST(ContinuationTable, BranchWithoutBifurcationsSaysSo) {
  v1::ContinuationResult result = Result();
  result.clear_bifurcations();
  EXPECT_THAT(ContinuationTable({}, result), ::testing::HasSubstr("no bifurcation met\n"));
}

}  // namespace
}  // namespace celt::cli
