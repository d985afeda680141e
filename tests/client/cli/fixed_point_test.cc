#include "client/cli/fixed_point.h"

#include "client/cli/fixed_point_table.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt::cli {
namespace {

using ::testing::HasSubstr;

void AddMultiplier(double re, double im, v1::Cycle& cycle) {
  cycle.add_multipliers()->set_re(re);
  cycle.mutable_multipliers()->rbegin()->set_im(im);
}

v1::Cycle Saddle() {
  v1::Cycle cycle;
  cycle.set_period(1);
  v1::Point& point = *cycle.add_points();
  point.set_l(2.25);
  point.set_l_over_g(-0.5);
  point.set_h_over_g(-0.375);
  cycle.set_return_time(0.75);
  AddMultiplier(-1.5, 0, cycle);
  AddMultiplier(0.25, 0.5, cycle);
  AddMultiplier(0.25, -0.5, cycle);
  cycle.set_residual(1.5e-14);
  cycle.set_correction(0.5e-12);
  cycle.set_type("saddle-focus 2-1");
  v1::Inequality& holds = *cycle.add_lorenz_conditions();
  holds.set_name("|gamma| > 1");
  holds.set_holds(true);
  holds.set_margin(0.5);
  v1::Inequality& fails = *cycle.add_lorenz_conditions();
  fails.set_name("real multipliers");
  fails.set_margin(-0.5);
  return cycle;
}

v1::FixedPointResult OneCycle() {
  v1::FixedPointResult result;
  *result.add_cycles() = Saddle();
  return result;
}

TEST(FixedPoint, SendsWhatWasGiven) {
  FakeService service;
  v1::StreamResultsResponse answer;
  *answer.mutable_result()->mutable_fixed_point() = OneCycle();
  service.scripts = {{{answer}, {}}};
  const Outcome outcome =
      RunCelt({"fixed-point", "--energy", "750", "--period", "2", "--near", "2.1,-0.6,-0.4",
               "--newton-tolerance", "1e-8", "--newton-iterations", "9"},
              {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const v1::FixedPointSpec spec = service.submitted().fixed_point();
  EXPECT_EQ(spec.period(), 2);
  EXPECT_EQ(spec.near().l_over_g(), -0.6);
  EXPECT_EQ(spec.newton_tolerance(), 1e-8);
  EXPECT_EQ(spec.newton_iterations(), 9);
  EXPECT_FALSE(spec.has_search());
  EXPECT_THAT(outcome.out, HasSubstr(R"({"result":{"cycles":[{"points":[{"l":2.25)"));
}

TEST(FixedPoint, SendsTheBoxOfASearch) {
  FakeService service;
  v1::StreamResultsResponse answer;
  *answer.mutable_result()->mutable_fixed_point() = OneCycle();
  service.scripts = {{{answer}, {}}};
  const Outcome outcome = RunCelt({"fixed-point", "--search", "1e3", "--seed", "7", "--lower",
                                   "0,-0.5,-0.5", "--upper", "3,0.5,0.5"},
                                  {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const v1::FixedPointSpec spec = service.submitted().fixed_point();
  EXPECT_EQ(spec.search(), 1000);
  EXPECT_EQ(spec.seed(), 7U);
  EXPECT_EQ(spec.lower().h_over_g(), -0.5);
  EXPECT_EQ(spec.upper().l(), 3);
}

TEST(FixedPoint, SaysNothingThatWasNotGiven) {
  v1::JobSpec spec;
  ASSERT_TRUE(MakeFixedPoint()->Fill(spec).ok());
  EXPECT_TRUE(spec.has_fixed_point());
  EXPECT_EQ(spec.fixed_point().ByteSizeLong(), 0U);
}

TEST(FixedPoint, RefusesAPointOfTwoNumbers) {
  for (const char* option : {"--near", "--lower", "--upper"}) {
    const Outcome outcome = RunCelt({"fixed-point", option, "1,2"}, {.server = "127.0.0.1:1"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err,
              std::string("celt: ") + option + ": 2 numbers where 3 are due: l,L/G,H/G\n");
  }
}

TEST(FixedPoint, CsvHasOneRowACycleAndNoneForTheResult) {
  v1::Record record;
  *record.mutable_fixed_point()->mutable_cycle() = Saddle();
  record.mutable_fixed_point()->set_first_start(12);
  const CsvRow expected = {{"l", "2.25"},
                           {"l_over_g", "-0.5"},
                           {"h_over_g", "-0.375"},
                           {"period", "1"},
                           {"type", "saddle-focus 2-1"},
                           {"return_time", "0.75"},
                           {"multiplier_1_re", "-1.5"},
                           {"multiplier_1_im", "0"},
                           {"multiplier_2_re", "0.25"},
                           {"multiplier_2_im", "0.5"},
                           {"multiplier_3_re", "0.25"},
                           {"multiplier_3_im", "-0.5"},
                           {"residual", "1.5e-14"},
                           {"first_start", "12"}};
  EXPECT_EQ(MakeFixedPoint()->Csv(record), expected);
  EXPECT_TRUE(MakeFixedPoint()->Csv(v1::Result()).empty());
}

TEST(FixedPointTable, ShowsACycleWithItsTest) {
  const FakeService service;
  EXPECT_EQ(FixedPointTable(service.job.spec(), OneCycle()),
            R"(Fixed point of celtic-stone at energy 752: saddle-focus 2-1

     l               L/G             H/G
  1  2.250000000000 -0.500000000000 -0.375000000000

  multipliers                    modulus
 -1.5000000000                   1.5000000000
  0.2500000000 ± 0.5000000000 i  0.5590169944

  return time      0.750000000000
  residual         1.5e-14
  last correction  5e-13

The paper's test for a discrete Lorenz attractor, with margins: ✗
  ✓  |γ| > 1           0.5
  ✗  real multipliers -0.5
)");
}

TEST(FixedPointTable, ShowsHowASearchWent) {
  v1::FixedPointResult result = OneCycle();
  *result.add_cycles() = Saddle();
  for (const int hits : {12, 0}) result.add_hits(hits);
  for (const int twins : {1, 0}) result.add_twins(twins);
  for (const int mirror : {1, 1}) result.add_mirrors(mirror);
  result.mutable_tally()->set_starts(2000);
  result.mutable_tally()->set_found(12);
  result.mutable_tally()->set_no_convergence(1988);
  result.mutable_accuracy()->set_map_error(2.5e-11);
  result.mutable_accuracy()->set_jacobian_error(1e-10);
  const FakeService service;
  EXPECT_EQ(FixedPointTable(service.job.spec(), result),
            R"(Fixed points of celtic-stone at energy 752: 2 found

1. saddle-focus 2-1, return time 0.7500000000
     l               L/G             H/G
  1  2.250000000000 -0.500000000000 -0.375000000000
  multipliers  -1.5000000000, 0.2500000000 ± 0.5000000000 i
  12 starts led here, 1 twin, mirror image of 2

2. saddle-focus 2-1, return time 0.7500000000
     l               L/G             H/G
  1  2.250000000000 -0.500000000000 -0.375000000000
  multipliers  -1.5000000000, 0.2500000000 ± 0.5000000000 i
  no start led here, its own mirror image

Of 2 000 starts 12 found a cycle, 1 988 did not converge.
  map error 2.5e-11, of its derivative 1e-10
)");
}

TEST(FixedPointTable, SearchThatFoundNothingSaysSo) {
  v1::FixedPointResult result;
  result.mutable_tally()->set_starts(3);
  result.mutable_tally()->set_outside(3);
  EXPECT_EQ(FixedPointTable({}, result),
            "Fixed points of celtic-stone: none found\n\n"
            "Of 3 starts 3 lay outside the domain.\n");
}

}  // namespace
}  // namespace celt::cli
