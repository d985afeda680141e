#include "client/cli/lyapunov.h"

#include "client/cli/lyapunov_table.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"

namespace celt::cli {
namespace {

TEST(LyapunovTable, SummarisesForPeople) {
  const FakeService service;
  EXPECT_EQ(LyapunovTable(service.job.spec(), ResultMessage().result().lyapunov()),
            R"(Lyapunov spectrum of celtic-stone at energy 752
20 000 iterates, 8 orbits

       per iterate        per unit of time
  Λ1   0.250 ± 0.013      0.500 ± 0.025
  Λ2   0.000 ± 0.013      0.000 ± 0.025
  Λ3  -0.500 ± 0.013     -1.000 ± 0.025
  sum -0.25000 ± 0.00021

  mean return time        0.5000 ± 0.0010
  Kaplan–Yorke dimension  2.5

Necessary for pseudo-hyperbolicity, with margins:
  ✓  Λ1 > 0       20 σ
  ?  Λ1 + Λ2 > 0  margin unknown
)");
}

TEST(LyapunovTable, MarksWhatIsNotSureAndShowsTheMapsErrorsWithWarnings) {
  v1::LyapunovResult result;
  result.set_iterates(10);
  result.set_orbits(16);
  result.set_regime(v1::REGIME_CHAOS);
  result.mutable_accuracy()->set_map_error(3.8e-11);
  result.mutable_accuracy()->set_jacobian_error(2e-10);
  result.mutable_accuracy()->add_warnings("lambda2: bad");
  result.add_map_error_per_iterate(1e-10);
  result.add_map_error_per_iterate(5e-10);
  const auto add = [&result](double slack, double margin) {
    v1::Condition& condition = *result.add_conditions();
    condition.set_name("lambda1 > 0");
    condition.set_holds(slack > 0);
    condition.set_margin(margin);
  };
  add(1, 3.5);
  add(1, 2.5);
  add(-1, -2.5);
  add(-1, -3.5);
  EXPECT_EQ(LyapunovTable({}, result),
            R"(Lyapunov spectrum of celtic-stone
10 iterates, 16 orbits

    per iterate  per unit of time

  regime              chaos
  error of the map    3.8e-11
    of its Jacobian   2.0e-10
    in the exponents  5.0e-10

Necessary for pseudo-hyperbolicity, with margins:
  ✓  Λ1 > 0  3.5 σ
  ?  Λ1 > 0  2.5 σ
  ?  Λ1 > 0 -2.5 σ
  ✗  Λ1 > 0 -3.5 σ

warning: Λ2: bad
)");
}

TEST(LyapunovTable, LeavesOutWhatTheResultDoesNotHave) {
  v1::LyapunovResult result;
  result.set_iterates(10);
  result.set_orbits(1);
  result.add_exponents_per_iterate(0.5);
  EXPECT_EQ(LyapunovTable({}, result),
            "Lyapunov spectrum of celtic-stone\n10 iterates, 1 orbit\n\n"
            "      per iterate  per unit of time\n  Λ1  0.5\n\n");
}

TEST(LyapunovCsv, RecordsAndResultShareTheirColumns) {
  const auto analysis = MakeLyapunov();
  const CsvRow record = analysis->Csv(RecordMessage(1).record());
  const CsvRow result = analysis->Csv(ResultMessage().result());
  ASSERT_EQ(record.size(), result.size());
  for (std::size_t i = 0; i < record.size(); ++i) EXPECT_EQ(record[i].first, result[i].first);
}

TEST(LyapunovCsv, ErrorsNotYetKnownAreEmptyCells) {
  const CsvRow row = MakeLyapunov()->Csv(RecordMessage(1).record());
  const CsvRow expected = {{"iterates", "100"},
                           {"exponent_per_iterate_1", "0.25"},
                           {"exponent_per_iterate_2", "0"},
                           {"exponent_per_iterate_3", "-0.5"},
                           {"standard_error_per_iterate_1", ""},
                           {"standard_error_per_iterate_2", ""},
                           {"standard_error_per_iterate_3", ""},
                           {"exponent_per_time_1", "0.5"},
                           {"exponent_per_time_2", "0"},
                           {"exponent_per_time_3", "-1"},
                           {"mean_return_time", "0.5"}};
  EXPECT_EQ(row, expected);
}

}  // namespace
}  // namespace celt::cli
