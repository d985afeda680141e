// Orbits, sections, manifolds and pseudo-hyperbolicity, as users ask for them.

#include <algorithm>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/e2e/daemon.h"

namespace celt {
namespace {

using ::testing::HasSubstr;

using Arguments = std::vector<std::string>;

struct Question {
  Arguments arguments;
  const char* key;  ///< in the result
};

const std::vector<Question>& Questions() {
  static const auto& questions = *new std::vector<Question>{
      {{"section", "--iterates", "50", "--backward"}, "\"meanReturnTime\""},
      {{"orbit", "--state", "0,0,-14,0.01,0.01,0.9999", "--time", "12", "--step", "0.1"},
       "\"reversals\":\"1\""},
      {{"manifold", "--system", "henon3d", "--near", "0.55,0.55,0.55", "--length", "2"},
       "\"sides\""},
      {{"hyperbolicity", "--system", "henon3d", "--set", "m2=0.815", "--iterates", "20000"},
       "\"verdict\":\"PSEUDO_HYPERBOLIC\""},
  };
  return questions;
}

TEST(Orbits, AreTheSameBytesEmbeddedAndRemote) {
  const TemporaryDirectory data;
  const Daemon daemon(data.path());
  const Celt celt;
  for (const Question& question : Questions()) {
    SCOPED_TRACE(question.arguments.front());
    const Ended embedded = celt.Run(question.arguments);
    const Ended remote = celt.Run(With(question.arguments, {"--server", daemon.address()}));
    EXPECT_EQ(embedded.code, 0) << embedded.err;
    EXPECT_EQ(remote.code, 0) << remote.err;
    EXPECT_EQ(embedded.out, remote.out);
    EXPECT_THAT(embedded.out, HasSubstr(question.key));
  }
}

TEST(Orbits, CsvIsATableOfRecordsAlone) {
  const Celt celt;
  for (const Question& question : Questions()) {
    const Ended run = celt.Run(With(question.arguments, {"--output", "csv"}));
    EXPECT_THAT(run.out, ::testing::StartsWith("row,sequence,"));
    EXPECT_THAT(run.out, ::testing::Not(HasSubstr("\nresult,"))) << question.arguments.front();
    const auto columns = [](const std::string& line) {
      return std::count(line.begin(), line.end(), ',');
    };
    const std::string header = run.out.substr(0, run.out.find('\n'));
    const std::string last = run.out.substr(run.out.rfind('\n', run.out.size() - 2) + 1);
    EXPECT_EQ(columns(last), columns(header)) << question.arguments.front();
  }
}

TEST(Orbits, FailureKeepsItsRecordsAndExitsOne) {
  const Celt celt;
  const Ended lost = celt.Run({"section", "--system", "henon3d", "--start", "50,50,50"});
  EXPECT_EQ(lost.code, 1);
  EXPECT_THAT(lost.err, HasSubstr("after 1 iterates: the orbit escapes"));
  EXPECT_EQ(std::count(lost.out.begin(), lost.out.end(), '\n'), 2);
  const Ended node = celt.Run({"manifold", "--energy", "747"});
  EXPECT_EQ(node.code, 1);
  EXPECT_THAT(node.err, HasSubstr("Its multipliers: 0.9737"));
}

TEST(Orbits, BadInputIsNamed) {
  const Celt celt;
  for (const auto& [arguments, named] : std::vector<std::pair<Arguments, std::string>>{
           {{"section", "--iterates", "0"}, "iterates: 0"},
           {{"section", "--iterates", "1e12"}, "iterates: 1000000000000"},
           {{"section", "--start", "1,1,0"}, "l_over_g: 1"},
           {{"orbit", "--step", "0"}, "step: 0"},
           {{"orbit", "--time", "1", "--step", "2"}, "step: 2"},
           {{"orbit", "--system", "henon3d"}, "system: henon3d"},
           {{"manifold", "--length", "nan"}, "--length"},
           {{"manifold", "--period", "0"}, "period: 0"},
           {{"hyperbolicity", "--iterates", "100"}, "[1900, "},
           {{"hyperbolicity", "--lenght", "100"}, "--lenght"},
       }) {
    const Ended run = celt.Run(arguments);
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_THAT(run.err, HasSubstr(named));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

}  // namespace
}  // namespace celt
