// The life of a job, by the commands of `celt jobs`.

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

const Arguments kQuestion = {"lyapunov", "--system", "henon3d", "--iterates", "2000"};

class JobsTest : public ::testing::Test {
 protected:
  Ended Run(const Arguments& arguments) const {
    return celt_.Run(With(arguments, {"--server", daemon_.address()}));
  }

  std::string Detach() const {
    const Ended run = Run(With(kQuestion, {"--detach", "--output", "table"}));
    EXPECT_EQ(run.code, 0) << run.err;
    return run.out.substr(0, run.out.find('\n'));
  }

  TemporaryDirectory data_;
  Daemon daemon_{data_.path()};
  Celt celt_;
};

TEST_F(JobsTest, DetachedJobIsWatchedToItsEndAndItsResultsReadAfterwards) {
  const std::string id = Detach();
  const Ended watched = Run({"jobs", "watch", id});
  EXPECT_EQ(watched.code, 0) << watched.err;
  EXPECT_THAT(watched.out, HasSubstr("\"state\":\"STATE_SUCCEEDED\""));
  const Ended results = Run({"jobs", "results", id});
  EXPECT_EQ(results.code, 0) << results.err;
  EXPECT_EQ(results.out, Run(kQuestion).out);
}

TEST_F(JobsTest, ResultsAfterARecordAreTheTail) {
  const std::string id = Detach();
  const std::string all = Run({"jobs", "results", id}).out;
  const std::string tail = Run({"jobs", "results", id, "--after", "1"}).out;
  EXPECT_EQ(tail, all.substr(all.find('\n') + 1));
}

TEST_F(JobsTest, ListAndGetShowTheSpecificationWithItsDefaults) {
  const std::string id = Detach();
  const Ended list = Run({"jobs", "list"});
  EXPECT_EQ(list.code, 0);
  EXPECT_THAT(list.out, StartsWith("{\"job\":{\"id\":\"" + id + "\""));
  const Ended got = Run({"jobs", "get", id});
  EXPECT_EQ(got.code, 0);
  EXPECT_THAT(got.out, HasSubstr("\"seed\":\"1\""));
}

TEST_F(JobsTest, CancelledJobEndsItsReadersWithoutAnswer) {
  const Ended detached = Run(
      {"lyapunov", "--system", "henon3d", "--iterates", "1e11", "--detach", "--output", "table"});
  const std::string id = detached.out.substr(0, detached.out.find('\n'));
  const auto reader = celt_.Start({"jobs", "results", id, "--server", daemon_.address()});
  EXPECT_EQ(Run({"jobs", "cancel", id}).code, 0);
  EXPECT_EQ(reader->Wait().code, 1);
  EXPECT_EQ(Run({"jobs", "watch", id}).code, 1);
  EXPECT_THAT(Run({"jobs", "get", id}).out, HasSubstr("\"state\":\"STATE_CANCELLED\""));
}

TEST_F(JobsTest, DeletedJobIsGone) {
  const std::string id = Detach();
  EXPECT_EQ(Run({"jobs", "delete", id}).code, 0);
  const Ended got = Run({"jobs", "get", id});
  EXPECT_EQ(got.code, 2);
  EXPECT_THAT(got.err, StartsWith("celt: "));
  EXPECT_THAT(got.err, HasSubstr(id));
}

TEST_F(JobsTest, ServerTellsWhatItKnows) {
  const Ended info = Run({"server", "info"});
  EXPECT_EQ(info.code, 0) << info.err;
  for (const char* name : {"celtic-stone", "lorenz", "henon3d", "section_angle"}) {
    EXPECT_THAT(info.out, HasSubstr(name));
  }
  EXPECT_THAT(info.out, HasSubstr("\"workers\":2"));
}

TEST_F(JobsTest, EmbeddedJobsAreKeptInTheDataDirectory) {
  const TemporaryDirectory data;
  EXPECT_EQ(celt_.Run(With(kQuestion, {"--data-dir", data.path()})).code, 0);
  const Ended list = celt_.Run({"jobs", "list", "--data-dir", data.path()});
  EXPECT_EQ(list.code, 0) << list.err;
  EXPECT_THAT(list.out, HasSubstr("\"state\":\"STATE_SUCCEEDED\""));
}

TEST_F(JobsTest, DataDirectoryInUseIsSaidWhereItWasAskedFor) {
  const Ended run = celt_.Run({"jobs", "list", "--data-dir", data_.path()});
  EXPECT_EQ(run.code, 3);
  EXPECT_THAT(run.err, StartsWith("celt: data directory "));
  EXPECT_THAT(run.err, HasSubstr("in use"));
}

}  // namespace
}  // namespace celt
