#include "client/cli/separatrix.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt::cli {
namespace {

v1::SeparatrixFate Fate(int changes) {
  v1::SeparatrixFate fate;
  fate.set_end(changes == 0 ? "tends to a cycle" : "wanders");
  fate.set_side(changes == 0 ? 1 : -1);
  fate.set_changes(changes);
  fate.set_iterates(1500);
  for (const double x : {0.5, 0.25}) fate.mutable_point()->add_x(x);
  return fate;
}

v1::Record Record() {
  v1::Record record;
  record.set_sequence(1);
  record.mutable_separatrix()->set_value(748.5);
  record.mutable_separatrix()->set_answer(true);
  *record.mutable_separatrix()->mutable_fate() = Fate(0);
  return record;
}

v1::SeparatrixResult Result() {
  v1::SeparatrixResult result;
  result.set_value(748.75);
  result.set_error(0.25);
  result.set_yes(748.5);
  result.set_no(749);
  *result.mutable_yes_fate() = Fate(0);
  *result.mutable_no_fate() = Fate(1);
  result.mutable_saddle()->add_x(0.125);
  result.mutable_accuracy()->add_warnings("something");
  return result;
}

TEST(Separatrix, SendsWhatWasGiven) {
  FakeService service;
  v1::StreamResultsResponse answer;
  *answer.mutable_result()->mutable_separatrix() = Result();
  service.scripts = {{{answer}, {}}};
  const Outcome outcome =
      RunCelt({"separatrix", "--question", "tends", "--parameter", "delta", "--from", "0.5", "--to",
               "0.25", "--width", "0.125", "--near", "2.1,-0.6,-0.4", "--period", "2", "--side",
               "-1", "--most-iterates", "1e4"},
              {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const v1::SeparatrixSpec spec = service.submitted().separatrix();
  EXPECT_EQ(spec.question(), v1::SEPARATRIX_QUESTION_TENDS);
  EXPECT_EQ(spec.parameter(), "delta");
  EXPECT_EQ(spec.from(), 0.5);
  EXPECT_EQ(spec.to(), 0.25);
  EXPECT_EQ(spec.width(), 0.125);
  EXPECT_EQ(spec.near().l(), 2.1);
  EXPECT_EQ(spec.period(), 2);
  EXPECT_EQ(spec.side(), -1);
  EXPECT_EQ(spec.most_iterates(), 10000);
}

TEST(Separatrix, SaysNothingThatWasNotGiven) {
  v1::JobSpec spec;
  ASSERT_TRUE(MakeSeparatrix()->Fill(spec).ok());
  EXPECT_TRUE(spec.has_separatrix());
  EXPECT_EQ(spec.separatrix().ByteSizeLong(), 0U);
}

TEST(Separatrix, CsvHasOneRowAValue) {
  const CsvRow expected = {{"value", "748.5"}, {"answer", "yes"}, {"end", "tends to a cycle"},
                           {"side", "1"},      {"changes", "0"},  {"iterates", "1500"},
                           {"x_1", "0.5"},     {"x_2", "0.25"}};
  EXPECT_EQ(MakeSeparatrix()->Csv(Record()), expected);
  EXPECT_TRUE(MakeSeparatrix()->Csv(v1::Result()).empty());
}

TEST(Separatrix, LineSaysWhatBecameOfIt) {
  EXPECT_EQ(
      MakeSeparatrix()->Line(Record()),
      "   748.5000000000  yes  tends to a cycle at (0.500000, 0.250000) after 1 500 iterates, "
      "always on its own side\n");
}

TEST(Separatrix, TableShowsTheBracket) {
  v1::JobSpec spec;
  spec.mutable_system()->set_name("celtic-stone");
  spec.mutable_separatrix()->set_parameter("energy");
  spec.mutable_separatrix()->set_side(1);
  EXPECT_EQ(SeparatrixTable(spec, Result()), R"(
Separatrix + of a saddle of celtic-stone: does it come back on its side?
the answer switches at energy 748.75 ± 0.25

  yes     748.5000000000  tends to a cycle at (0.500000, 0.250000) after 1 500 iterates, always on its own side
  no      749.0000000000  wanders after 1 500 iterates, last on side −
  saddle  (0.125000)
  warning: something
)");
}

}  // namespace
}  // namespace celt::cli
