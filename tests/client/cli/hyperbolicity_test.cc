#include "client/cli/hyperbolicity.h"

#include "client/cli/hyperbolicity_table.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

v1::Result Measured(v1::HyperbolicityVerdict verdict) {
  v1::Result result;
  v1::HyperbolicityResult& out = *result.mutable_hyperbolicity();
  out.set_verdict(verdict);
  out.set_samples(39700);
  out.set_minimum_angle(0.0004);
  out.mutable_minimum_point()->set_l(2.25);
  out.mutable_minimum_point()->set_l_over_g(-0.5);
  out.mutable_minimum_point()->set_h_over_g(-0.25);
  for (const double angle : {0.002, 0.002, 0.001, 0.0004}) out.add_minimum_by_length(angle);
  out.set_tail_index(0.97);
  out.set_promised_minimum(3.5e-6);
  for (const double exponent : {0.25, 0.0, -0.5}) {
    out.add_exponents_per_iterate(exponent);
    out.add_standard_error_per_iterate(0.0125);
  }
  out.add_conditions()->set_holds(true);
  const bool torn = verdict == v1::TANGENCIES;
  for (const char* name : {"exponents", "angle"}) {
    v1::HyperbolicityTest& test = *out.add_tests();
    const bool failed = torn && std::string(name) == "angle";
    test.set_name(name);
    test.set_outcome(failed ? "failed" : "passed");
    test.set_margin(failed ? -4.5 : 51.5);
    test.set_why(std::string("of ") + name);
  }
  v1::LmpBin& bin = *out.add_lmp_graph();
  bin.set_from(0.01);
  bin.set_to(0.0178);
  bin.set_pairs(12345);
  bin.set_largest_angle(0.9);
  return result;
}

TEST(Hyperbolicity, SendsWhatWasGiven) {
  FakeService service;
  v1::StreamResultsResponse answer;
  *answer.mutable_result() = Measured(v1::TANGENCIES);
  service.scripts = {{{answer}, {}}};
  const Outcome outcome = RunCelt({"hyperbolicity", "--iterates", "1e5", "--transient", "10",
                                   "--scout", "500", "--seed", "3", "--start", "2.1,-0.6,-0.4"},
                                  {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const v1::HyperbolicitySpec spec = service.submitted().hyperbolicity();
  EXPECT_EQ(spec.iterates(), 100'000);
  EXPECT_EQ(spec.transient(), 10);
  EXPECT_EQ(spec.scout(), 500);
  EXPECT_EQ(spec.seed(), 3U);
  EXPECT_EQ(spec.start().l(), 2.1);
  EXPECT_THAT(outcome.out, HasSubstr("{\"result\":{\"verdict\":\"TANGENCIES\","));
  EXPECT_THAT(outcome.out, HasSubstr("\"minimumAngle\":0.0004"));
  EXPECT_THAT(outcome.out, HasSubstr("\"conditions\":["));
}

TEST(Hyperbolicity, CsvIsTheHistory) {
  v1::Record record;
  record.mutable_hyperbolicity()->set_iterates(8000);
  record.mutable_hyperbolicity()->set_minimum_angle(0.5);
  record.mutable_hyperbolicity()->add_exponents_per_iterate(0.25);
  const CsvRow expected = {
      {"iterates", "8000"}, {"minimum_angle", "0.5"}, {"exponent_per_iterate_1", "0.25"}};
  EXPECT_EQ(MakeHyperbolicity()->Csv(record), expected);
  EXPECT_TRUE(MakeHyperbolicity()->Csv(Measured(v1::TANGENCIES)).empty());
}

TEST(HyperbolicityTable, SaysWhichTestPassedWithWhatMargin) {
  const FakeService service;
  EXPECT_EQ(HyperbolicityTable(service.job.spec(), Measured(v1::TANGENCIES).hyperbolicity()),
            R"(Pseudo-hyperbolicity of celtic-stone at energy 752
39 700 samples along one orbit; angles and distances in whitened coordinates

  Λ1 0.250 ± 0.013, Λ2 0.000 ± 0.013, Λ3 -0.500 ± 0.013 per iterate

  minimum angle [rad]                      0.0004
  at                                       (2.250000, -0.500000, -0.250000)
  over 1/8, 1/4, 1/2 and all of the orbit  0.002, 0.002, 0.001, 0.0004
  tail index                               0.97
  promised for an orbit 100 times longer   3.5e-06

Pairs of points of the orbit (LMP graph):
  distance below  pairs   largest angle [rad]
  0.0178          12 345  0.9

Tests:
     test       margin
  ✓  exponents  51.5    the paper's conditions on the exponents [standard errors]
  ✗  angle     -4.5     E^ss and E^cu stay apart [decades]
    exponents: of exponents
    angle: of angle

TANGENCIES: E^ss meets E^cu or is not continuous (failed: angle).
The paper's conditions on the exponents hold, and yet the attractor is not
pseudo-hyperbolic: those conditions are necessary, not sufficient.
)");
}

TEST(HyperbolicityTable, BlamesTheConditionsOnlyWhereTheyHoldInVain) {
  const std::string passed =
      HyperbolicityTable({}, Measured(v1::PSEUDO_HYPERBOLIC).hyperbolicity());
  EXPECT_THAT(passed, HasSubstr("\nPSEUDO-HYPERBOLIC: every test was passed.\n"));
  EXPECT_THAT(passed, Not(HasSubstr("necessary")));
  v1::Result broken = Measured(v1::TANGENCIES);
  broken.mutable_hyperbolicity()->mutable_conditions(0)->set_holds(false);
  EXPECT_THAT(HyperbolicityTable({}, broken.hyperbolicity()), Not(HasSubstr("necessary")));
  EXPECT_THAT(HyperbolicityTable({}, Measured(v1::UNDECIDED).hyperbolicity()),
              HasSubstr("\nUNDECIDED: "));
}

}  // namespace
}  // namespace celt::cli
