#include "client/cli/section.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt::cli {
namespace {

v1::Record StoneRecord() {
  v1::Record record;
  record.set_sequence(1);
  v1::SectionRecord& section = *record.mutable_section();
  section.set_iterate(3);
  section.mutable_point()->set_l(2.25);
  section.mutable_point()->set_l_over_g(-0.5);
  section.mutable_point()->set_h_over_g(-0.375);
  section.set_time(2.5);
  section.set_return_time(0.75);
  return record;
}

v1::Result StoneResult() {
  v1::Result result;
  v1::SectionResult& section = *result.mutable_section();
  section.set_iterates(20000);
  section.set_mean_return_time(0.75);
  *section.mutable_last() = StoneRecord().section().point();
  for (const double x : {2.0, -0.75, -0.5}) section.add_lowest(x);
  for (const double x : {2.5, -0.25, -0.25}) section.add_highest(x);
  section.mutable_accuracy()->set_map_error(3e-11);
  section.mutable_accuracy()->set_jacobian_error(2e-10);
  return result;
}

TEST(Section, SendsWhatWasGiven) {
  FakeService service;
  v1::StreamResultsResponse answer;
  *answer.mutable_result() = StoneResult();
  service.scripts = {{{answer}, {}}};
  const Outcome outcome = RunCelt({"section", "--energy", "750", "--iterates", "7", "--transient",
                                   "3", "--backward", "--start", "2.1,-0.6,-0.4"},
                                  {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const v1::SectionSpec spec = service.submitted().section();
  EXPECT_EQ(spec.iterates(), 7);
  EXPECT_EQ(spec.transient(), 3);
  EXPECT_EQ(spec.direction(), v1::DIRECTION_BACKWARD);
  EXPECT_EQ(spec.start().l_over_g(), -0.6);
}

TEST(Section, SaysNothingThatWasNotGiven) {
  v1::JobSpec spec;
  ASSERT_TRUE(MakeSection()->Fill(spec).ok());
  EXPECT_TRUE(spec.has_section());
  EXPECT_EQ(spec.section().ByteSizeLong(), 0U);
}

TEST(Section, CsvHasOneRowAnIterateAndNoneForTheResult) {
  const CsvRow expected = {{"iterate", "3"},       {"l", "2.25"},   {"l_over_g", "-0.5"},
                           {"h_over_g", "-0.375"}, {"time", "2.5"}, {"return_time", "0.75"}};
  EXPECT_EQ(MakeSection()->Csv(StoneRecord()), expected);
  EXPECT_TRUE(MakeSection()->Csv(StoneResult()).empty());
}

TEST(Section, CsvNumbersTheCoordinatesOfOtherSystems) {
  v1::Record record;
  record.mutable_section()->mutable_point()->add_x(0.5);
  record.mutable_section()->mutable_point()->add_x(1.5);
  const CsvRow expected = {
      {"iterate", "0"}, {"x_1", "0.5"}, {"x_2", "1.5"}, {"time", "0"}, {"return_time", ""}};
  EXPECT_EQ(MakeSection()->Csv(record), expected);
}

TEST(Section, LinesAlignUnderTheHeaderOfTheFirst) {
  v1::Record record = StoneRecord();
  const std::string line =
      "             3   2.250000000  -0.500000000  -0.375000000      2.500000\n";
  EXPECT_EQ(MakeSection()->Line(record),
            "       iterate             l           L/G           H/G          time\n" + line);
  record.set_sequence(2);
  EXPECT_EQ(MakeSection()->Line(record), line);
}

TEST(Section, TableIsTheOrbitAsAWhole) {
  const FakeService service;
  EXPECT_EQ(MakeSection()->Table(service.job, StoneResult()), R"(
Orbit of the section map of celtic-stone at energy 752
20 000 iterates, mean return time 0.75

       lowest       highest      last
  l    2.000000000  2.500000000  2.250000000
  L/G -0.750000000 -0.250000000 -0.500000000
  H/G -0.500000000 -0.250000000 -0.375000000
  map error 3e-11, of its derivative 2e-10
)");
}

}  // namespace
}  // namespace celt::cli
