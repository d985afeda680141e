// Cycles, from the command line to the answer.

#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/e2e/daemon.h"

namespace celt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

using Arguments = std::vector<std::string>;

const Arguments kFast = {"--engine", "fast"};

TEST(FixedPoint, SameBytesEmbeddedAndRemote) {
  const TemporaryDirectory data;
  const Daemon daemon(data.path());
  const Celt celt;
  const Arguments question = With({"fixed-point", "--search", "24"}, kFast);
  const Ended embedded = celt.Run(question);
  EXPECT_EQ(embedded.code, 0) << embedded.err;
  EXPECT_EQ(embedded.out, celt.Run(With(question, {"--server", daemon.address()})).out);
  // O* to nine decimals (tests/reference/celtic_stone.json).
  EXPECT_THAT(embedded.out, HasSubstr("\"lOverG\":-0.669144118"));
}

TEST(FixedPoint, TableHasThePapersTest) {
  const Ended run = Celt().Run(With({"fixed-point", "--output", "table"}, kFast));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("saddle 2-1"));
  EXPECT_THAT(run.out, HasSubstr("0.96606133"));
  EXPECT_THAT(run.out, HasSubstr("✓  |λ1 γ| > 1"));
}

TEST(FixedPoint, GuessThatDoesNotConvergeExitsOneAndABadOneTwo) {
  const Celt celt;
  const Ended none =
      celt.Run(With({"fixed-point", "--near", "2.1,-0.6,-0.3", "--newton-iterations", "1"}, kFast));
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.err, HasSubstr("no convergence in 1 iterations; residual "));
  const Ended bad = celt.Run({"fixed-point", "--period", "0"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.err, StartsWith("celt: period: 0 is not allowed"));
}

TEST(Continue, FindsThePeriodDoublingAndSaysHowTheBranchEnded) {
  const Celt celt;
  const Arguments question = With({"continue", "--from", "748", "--to", "747.5"}, kFast);
  const Ended json = celt.Run(question);
  EXPECT_EQ(json.code, 0) << json.err;
  EXPECT_THAT(json.out,
              HasSubstr("\"bifurcations\":[{\"type\":\"PERIOD_DOUBLING\",\"value\":747.78555"));
  const Ended table = celt.Run(With(question, {"--output", "table"}));
  EXPECT_THAT(table.out, HasSubstr("reached the end"));
  EXPECT_THAT(table.out, HasSubstr("supercritical"));
}

TEST(Continue, GuessThatDoesNotConvergeExitsOneAndABadIntervalTwo) {
  const Celt celt;
  const Ended none = celt.Run(With({"continue", "--to", "750", "--near", "1,0.3,0.2"}, kFast));
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.err, HasSubstr("at energy 752: no cycle of period 1 found: "));
  const Ended bad = celt.Run({"continue", "--to", "752"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.err, StartsWith("celt: to: 752 is not allowed"));
}

TEST(Separatrix, BracketIsTheSameEmbeddedAndRemote) {
  const TemporaryDirectory data;
  const Daemon daemon(data.path());
  const Celt celt;
  const Arguments question =
      With({"separatrix", "--from", "748.4", "--to", "748.5", "--width", "1e-2"}, kFast);
  const Ended embedded = celt.Run(question);
  EXPECT_EQ(embedded.code, 0) << embedded.err;
  EXPECT_EQ(embedded.out, celt.Run(With(question, {"--server", daemon.address()})).out);
  EXPECT_THAT(embedded.out, HasSubstr("{\"result\":{\"value\":748.44"));
}

TEST(Separatrix, EndsThatAgreeExitOneAndMissingOnesTwo) {
  const Celt celt;
  const Ended same = celt.Run(With({"separatrix", "--from", "748.4", "--to", "748.41"}, kFast));
  EXPECT_EQ(same.code, 1);
  EXPECT_THAT(same.err, HasSubstr("the separatrix does the same at both ends"));
  EXPECT_THAT(same.out, HasSubstr("\"value\":748.41"));
  const Ended bad = celt.Run({"separatrix", "--from", "748.4"});
  EXPECT_EQ(bad.code, 2);
  EXPECT_EQ(bad.err, "celt: to: missing\n");
}

}  // namespace
}  // namespace celt
