#include "client/cli/sweep.h"

#include <string>
#include <vector>

#include "client/cli/json.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt::cli {
namespace {

using Arguments = std::vector<std::string>;

/// The specification that `celt sweep <options>` submits, as JSON.
std::string Submitted(Arguments options) {
  FakeService service;
  v1::StreamResultsResponse result;
  result.mutable_result()->mutable_sweep()->set_nodes(3);
  service.scripts = {{{result}, {}}};
  options.insert(options.begin(), "sweep");
  const Outcome outcome = RunCelt(options, {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return ToJson(service.submitted());
}

std::string Refused(Arguments options) {
  options.insert(options.begin(), "sweep");
  const Outcome outcome = RunCelt(options, {.server = "127.0.0.1:1"});
  EXPECT_EQ(outcome.code, 2) << outcome.err;
  return outcome.err;
}

TEST(SweepOptions, TakeAxesAndTheOptionsOfTheAnalysisAndOfTheSystem) {
  EXPECT_EQ(
      Submitted({"--axis", "energy=752:752.01:101", "--follow", "lyapunov", "--iterates", "2000",
                 "--delta", "0.4"}),
      R"({"system":{"parameters":{"delta":0.4}},"sweep":{"axes":[{"parameter":"energy",)"
      R"("from":752,"to":752.01,"nodes":101}],"follow":true,"lyapunov":{"iterates":"2000"}}})");
}

TEST(SweepOptions, TakeTwoAxesForAChart) {
  EXPECT_EQ(Submitted({"--axis", "energy=1:2:3", "--axis", "delta=-0.5:0.5:4", "lyapunov"}),
            R"({"sweep":{"axes":[{"parameter":"energy","from":1,"to":2,"nodes":3},)"
            R"({"parameter":"delta","from":-0.5,"to":0.5,"nodes":4}],"lyapunov":{}}})");
}

TEST(SweepOptions, RefuseWhatIsNoAxis) {
  for (const char* const text : {"energy", "energy=1:2", "=1:2:3", "energy=1:2:3:4", "energy"}) {
    EXPECT_NE(Refused({"--axis", text, "lyapunov"}).find("is not NAME=FROM:TO:NODES"),
              std::string::npos)
        << text;
  }
  EXPECT_NE(Refused({"--axis", "energy=1:x:3", "lyapunov"}).find("'x' is no finite number"),
            std::string::npos);
  EXPECT_NE(Refused({"--axis", "energy=1:2:1.5", "lyapunov"}).find("'1.5' is no whole number"),
            std::string::npos);
}

TEST(SweepOptions, AskForAnAnalysis) {
  EXPECT_NE(Refused({"--axis", "energy=1:2:3"}).find("celt sweep --help"), std::string::npos);
}

v1::Record RecordOf(int node, bool failed) {
  v1::Record record;
  v1::SweepRecord& sweep = *record.mutable_sweep();
  sweep.set_node(node);
  sweep.add_values(0.5);
  if (failed) {
    sweep.mutable_error()->set_message("lost");
    return record;
  }
  *sweep.mutable_lyapunov() = ResultMessage().result().lyapunov();
  return record;
}

TEST(SweepCsv, NodesThatFailedHaveTheColumnsOfTheOthers) {
  const auto sweep = MakeSweep();
  const CsvRow good = sweep->Csv(RecordOf(0, false));
  const CsvRow bad = sweep->Csv(RecordOf(1, true));
  ASSERT_EQ(good.size(), bad.size());
  for (std::size_t i = 0; i < good.size(); ++i) EXPECT_EQ(good[i].first, bad[i].first);
  EXPECT_EQ(good[1], (std::pair<std::string, std::string>("value_1", "0.5")));
  EXPECT_EQ(good[2].second, "");
  EXPECT_EQ(bad[2].second, "lost");
}

TEST(SweepCsv, ColumnsAreThoseOfTheAnalysisAskedForWhenTheFirstNodeFails) {
  FakeService service;
  v1::StreamResultsResponse failed;
  *failed.mutable_record() = RecordOf(0, true);
  failed.mutable_record()->set_sequence(1);
  v1::StreamResultsResponse result;
  result.mutable_result()->mutable_sweep()->set_nodes(1);
  service.scripts = {{{failed, result}, {}}};
  const Outcome outcome =
      RunCelt({"sweep", "--axis", "energy=1:2:2", "fixed-point", "--output", "csv"},
              {.server = service.address()});
  EXPECT_NE(outcome.out.find("value_1,error,cycles,type,return_time,x_1"), std::string::npos)
      << outcome.out;
}

v1::SweepRecord Sample(const std::string& analysis) {
  v1::SweepRecord sweep;
  if (analysis == "section") sweep.mutable_section()->add_lowest(1);
  if (analysis == "fixed_point") {
    v1::Cycle& cycle = *sweep.mutable_fixed_point()->add_cycles();
    cycle.add_points()->add_x(0.25);
    cycle.add_multipliers()->set_re(2);
    cycle.set_type("saddle 2-1");
  }
  if (analysis == "continuation") {
    v1::Bifurcation& fold = *sweep.mutable_continuation()->add_bifurcations();
    fold.set_type(v1::FOLD);
    fold.set_value(0.75);
    sweep.mutable_continuation()->add_branches()->set_end("reached the end");
  }
  if (analysis == "manifold") {
    for (const int side : {1, -1}) {
      v1::ManifoldSide& half = *sweep.mutable_manifold()->add_sides();
      half.set_side(side);
      half.mutable_fate()->set_end("wanders");
    }
  }
  if (analysis == "separatrix") {
    sweep.mutable_separatrix()->set_value(748.44);
    sweep.mutable_separatrix()->set_error(0.01);
  }
  if (analysis == "hyperbolicity") {
    sweep.mutable_hyperbolicity()->set_verdict(v1::TANGENCIES);
    sweep.mutable_hyperbolicity()->set_minimum_angle(0.125);
  }
  return sweep;
}

TEST(SweepCsv, EveryAnalysisHasTheSameColumnsAtANodeThatFailed) {
  for (const std::string analysis :
       {"section", "fixed_point", "continuation", "manifold", "separatrix", "hyperbolicity"}) {
    const auto sweep = MakeSweep();
    v1::Record good;
    *good.mutable_sweep() = Sample(analysis);
    v1::Record bad;
    bad.mutable_sweep()->mutable_error()->set_message("lost");
    const CsvRow filled = sweep->Csv(good);
    const CsvRow empty = sweep->Csv(bad);
    ASSERT_EQ(filled.size(), empty.size()) << analysis;
    EXPECT_GT(filled.size(), 4U) << analysis;
    for (std::size_t i = 0; i < filled.size(); ++i) EXPECT_EQ(filled[i].first, empty[i].first);
  }
}

TEST(SweepTable, HasALineForEachNode) {
  const auto sweep = MakeSweep();
  EXPECT_EQ(sweep->Line(RecordOf(0, false)), "  0.5  Λ   0.25000   0.00000  -0.50000  not told\n");
  EXPECT_EQ(sweep->Line(RecordOf(1, true)), "  0.5  ✗ lost\n");
}

TEST(SweepTable, SaysOfBranchesAndSeparatricesWhereTheyChange) {
  const auto line = [](const std::string& analysis) {
    v1::Record record;
    *record.mutable_sweep() = Sample(analysis);
    record.mutable_sweep()->add_values(0.5);
    return MakeSweep()->Line(record);
  };
  EXPECT_EQ(line("continuation"), "  0.5  FOLD at 0.7500000000; reached the end\n");
  EXPECT_EQ(line("separatrix"), "  0.5  switches at 748.440 ± 0.010\n");
}

}  // namespace
}  // namespace celt::cli
