#include "client/cli/orbit.h"

#include <algorithm>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt::cli {
namespace {

using ::testing::HasSubstr;

v1::Record Instant() {
  v1::Record record;
  record.set_sequence(2);
  v1::OrbitRecord& orbit = *record.mutable_orbit();
  orbit.set_time(0.5);
  for (const double x : {1.0, 2.0, 3.0}) {
    orbit.add_momentum(x);
    orbit.add_gamma(x / 4);
    orbit.add_angular_velocity(-x);
    orbit.add_contact_on_body(2 * x);
  }
  orbit.add_contact_on_plane(0.25);
  orbit.add_contact_on_plane(-0.25);
  orbit.set_spin_rate(-2);
  orbit.set_turns(-0.125);
  orbit.set_momentum_length(4);
  return record;
}

v1::Result Whole() {
  v1::Result result;
  v1::OrbitResult& orbit = *result.mutable_orbit();
  orbit.set_records(2001);
  orbit.set_time(40);
  orbit.set_energy(114.5);
  orbit.set_reversals(2);
  orbit.set_turns(-1.5);
  orbit.set_energy_drift(1.2e-10);
  orbit.set_gamma_drift(1e-13);
  return result;
}

TEST(Orbit, SendsWhatWasGiven) {
  FakeService service;
  v1::StreamResultsResponse answer;
  *answer.mutable_result() = Whole();
  service.scripts = {{{answer}, {}}};
  const Outcome outcome = RunCelt({"orbit", "--state", "0,0,-14,0.01,0.01,0.9999", "--time", "40",
                                   "--step", "0.02", "--turns", "3", "--backward"},
                                  {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const v1::OrbitSpec spec = service.submitted().orbit();
  EXPECT_THAT(spec.state(), ::testing::ElementsAre(0, 0, -14, 0.01, 0.01, 0.9999));
  EXPECT_EQ(spec.time(), 40);
  EXPECT_EQ(spec.step(), 0.02);
  EXPECT_EQ(spec.turns(), 3);
  EXPECT_EQ(spec.direction(), v1::DIRECTION_BACKWARD);
}

TEST(Orbit, StateAndWhatContradictsItAreRefused) {
  const std::vector<std::string> state = {"orbit", "--state", "0,0,-14,0,0,1"};
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--start", "2,-0.6,-0.3"}, {"--energy", "752"}}) {
    std::vector<std::string> arguments = state;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = RunCelt(arguments);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("--state: not together with " + more[0]));
  }
  EXPECT_EQ(RunCelt({"orbit", "--state", "1,2,3"}).code, 2);
  EXPECT_EQ(RunCelt({"orbit", "--step", "nan"}).code, 2);
}

TEST(Orbit, CsvHasTheSameColumnsWithAnglesAndWithout) {
  v1::Record with = Instant();
  with.mutable_orbit()->mutable_andoyer()->set_l(1.5);
  with.mutable_orbit()->mutable_andoyer()->set_l_over_g(0.75);
  with.mutable_orbit()->mutable_andoyer()->set_h_over_g(0.5);
  with.mutable_orbit()->set_g(0.25);
  const CsvRow a = MakeOrbit()->Csv(with);
  const CsvRow b = MakeOrbit()->Csv(Instant());
  ASSERT_EQ(a.size(), 25U);
  ASSERT_EQ(b.size(), a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].first, b[i].first);
    EXPECT_NE(a[i].second, "") << a[i].first;
  }
  const auto cell = [](const CsvRow& row, const std::string& name) {
    const auto found =
        std::find_if(row.begin(), row.end(), [&](const auto& c) { return c.first == name; });
    return found == row.end() ? "missing" : found->second;
  };
  EXPECT_EQ(cell(a, "gamma_3"), "0.75");
  EXPECT_EQ(cell(a, "l_over_g"), "0.75");
  EXPECT_EQ(cell(b, "l_over_g"), "");
  EXPECT_EQ(cell(b, "turns"), "-0.125");
  EXPECT_TRUE(MakeOrbit()->Csv(Whole()).empty());
}

TEST(Orbit, LineIsWhatOneWatches) {
  EXPECT_EQ(MakeOrbit()->Line(Instant()),
            "    0.500000   -2.000000   -0.125000    0.750000    0.250000   -0.250000\n");
}

TEST(Orbit, TableIsTheOrbitAsAWhole) {
  const FakeService service;
  EXPECT_EQ(MakeOrbit()->Table(service.job, Whole()), R"(
Orbit of the celtic-stone at energy 752

  records                   2 001
  time                      40
  turns about the vertical -1.5
  reversals of the spin     2
  energy                    114.5
  drift of energy           1.2e-10
  drift of |gamma|          1e-13
)");
}

}  // namespace
}  // namespace celt::cli
