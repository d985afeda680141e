#include "client/cli/run.h"

#include <algorithm>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

FakeService::Script Answer() { return {{RecordMessage(1), ResultMessage()}, {}}; }

class RunTest : public ::testing::Test {
 protected:
  Outcome Run(std::vector<std::string> arguments) {
    return RunCelt(arguments, {.server = service_.address()});
  }
  FakeService service_;
};

TEST_F(RunTest, JsonIsRecordsThenResultOneALine) {
  service_.scripts = {{{RecordMessage(1), RecordMessage(2), ResultMessage()}, {}}};
  const Outcome outcome = Run({"lyapunov"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, StartsWith(R"({"sequence":"1","lyapunov":{"iterates":"100",)"));
  EXPECT_THAT(outcome.out, HasSubstr("\n{\"sequence\":\"2\","));
  EXPECT_THAT(outcome.out, HasSubstr("\n{\"result\":{\"exponentsPerIterate\":[0.25,0,-0.5],"
                                     "\"exponentsPerTime\":[0.5,0,-1],"));
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 3);
}

TEST_F(RunTest, TableIsTheDefaultOnATerminalOnly) {
  service_.scripts = {Answer()};
  const Outcome outcome =
      RunCelt({"lyapunov"}, {.server = service_.address(), .out_is_terminal = true});
  EXPECT_THAT(outcome.out, StartsWith("Lyapunov spectrum of celtic-stone at energy 752\n"));
  const Outcome asked = RunCelt({"lyapunov", "--output", "json"},
                                {.server = service_.address(), .out_is_terminal = true});
  EXPECT_THAT(asked.out, StartsWith("{"));
}

TEST_F(RunTest, CsvIsAHeaderRecordsAndTheResult) {
  service_.scripts = {Answer()};
  const Outcome outcome = Run({"lyapunov", "--output", "csv"});
  EXPECT_THAT(outcome.out, StartsWith("row,sequence,iterates,exponent_per_iterate_1,"));
  EXPECT_THAT(outcome.out, HasSubstr("\nrecord,1,100,0.25,0,-0.5,,,,0.5,0,-1,0.5\n"));
  EXPECT_THAT(outcome.out, HasSubstr("\nresult,,20000,0.25,0,-0.5,0.0125,0.0125,0.0125,"));
}

TEST_F(RunTest, DetachPrintsTheIdAndLeavesTheJob) {
  EXPECT_EQ(Run({"lyapunov", "--detach"}).out, "{\"job\":{\"id\":\"job-1\"}}\n");
  EXPECT_EQ(Run({"lyapunov", "--detach", "--output", "table"}).out, "job-1\n");
  EXPECT_TRUE(service_.resumed_after().empty());
  EXPECT_FALSE(service_.cancelled());
}

TEST_F(RunTest, KnownAnswerIsSaidToBeOne) {
  service_.scripts = {Answer()};
  EXPECT_EQ(Run({"lyapunov"}).err, "");
  service_.job.set_state(v1::Job::STATE_SUCCEEDED);
  EXPECT_EQ(Run({"lyapunov"}).err, "celt: known already, by job job-1; --fresh computes it anew\n");
}

TEST_F(RunTest, FreshAnswerIsAskedFor) {
  Run({"lyapunov", "--detach"});
  EXPECT_FALSE(service_.fresh());
  Run({"lyapunov", "--detach", "--fresh"});
  EXPECT_TRUE(service_.fresh());
}

TEST_F(RunTest, DetachTellsHowLongTheJobTakes) {
  v1::Estimate& estimate = *service_.job.mutable_estimate();
  estimate.set_most_units(135);
  estimate.set_iterates(216'000);
  estimate.set_seconds(65);
  EXPECT_EQ(Run({"lyapunov", "--detach"}).err,
            "celt: job job-1 takes about 1:05: 216 000 iterates in 135 units\n");
  estimate.clear_iterates();
  estimate.clear_most_units();
  estimate.set_seconds(0.123);
  estimate.set_queue_seconds(30);
  EXPECT_EQ(Run({"lyapunov", "--detach"}).err,
            "celt: job job-1 takes about 0.12 s; 30 s of other jobs before or beside it\n");
}

TEST_F(RunTest, WhoWaitsIsToldHowLongOnATerminalAndOnlyIfItIsLong) {
  service_.scripts = {Answer()};
  service_.job.mutable_estimate()->set_seconds(100);
  const Surroundings terminal = {.server = service_.address(), .progress_width = 80};
  EXPECT_THAT(RunCelt({"lyapunov"}, terminal).err, HasSubstr("job job-1 takes about 1:40\n"));
  EXPECT_EQ(Run({"lyapunov"}).err, "");
  service_.job.mutable_estimate()->set_seconds(1);
  EXPECT_THAT(RunCelt({"lyapunov"}, terminal).err, Not(HasSubstr("takes")));
}

TEST_F(RunTest, DryRunNamesTheJobThatHasGivenTheAnswer) {
  service_.job.set_id("known");
  service_.job.set_state(v1::Job::STATE_SUCCEEDED);
  EXPECT_EQ(Run({"lyapunov", "--dry-run", "--output", "table"}).out,
            "  known already, by job known; --fresh computes it anew\n");
  EXPECT_EQ(Run({"lyapunov", "--dry-run", "--output", "csv"}).out,
            "most_units,iterates,seconds,queue_seconds,known_by\n0,0,0,0,known\n");
  EXPECT_THAT(Run({"lyapunov", "--dry-run"}).out, HasSubstr("\"id\":\"known\""));
  EXPECT_TRUE(service_.resumed_after().empty());
}

TEST_F(RunTest, DryRunTellsTheWorkInAllFormatsAndLeavesNoJob) {
  service_.job.clear_id();
  v1::Estimate& estimate = *service_.job.mutable_estimate();
  estimate.set_most_units(1);
  estimate.set_iterates(1e6);
  estimate.set_seconds(3700);
  EXPECT_EQ(Run({"lyapunov", "--dry-run", "--output", "table"}).out,
            "  work          1 000 000 iterates in 1 unit\n"
            "  computes for  about 1:01:40\n"
            "  other jobs    none\n");
  EXPECT_TRUE(service_.validate_only());
  EXPECT_EQ(Run({"lyapunov", "--dry-run", "--output", "csv"}).out,
            "most_units,iterates,seconds,queue_seconds,known_by\n1,1e+06,3700,0,\n");
  EXPECT_THAT(
      Run({"lyapunov", "--dry-run"}).out,
      HasSubstr("\"estimate\":{\"mostUnits\":\"1\",\"iterates\":1000000,\"seconds\":3700}"));
  EXPECT_TRUE(service_.resumed_after().empty());
  EXPECT_EQ(Run({"lyapunov", "--dry-run", "--detach"}).code, 2);
}

TEST_F(RunTest, DetachWithoutServerIsRefused) {
  const Outcome outcome = RunCelt({"lyapunov", "--detach"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, StartsWith("celt: --detach: needs --server"));
}

TEST_F(RunTest, OptionOfTheServerWinsOverTheEnvironmentAndMayComeFirst) {
  service_.scripts = {Answer()};
  EXPECT_EQ(RunCelt({"--server", service_.address(), "lyapunov"}, {.server = "127.0.0.1:1"}).code,
            0);
  EXPECT_EQ(RunCelt({"lyapunov", "--server", service_.address()}, {.server = "127.0.0.1:1"}).code,
            0);
}

TEST_F(RunTest, BadAddressInTheEnvironmentIsNamed) {
  const Outcome outcome = RunCelt({"server", "info"}, {.server = "nowhere"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.err, "celt: CELT_SERVER: 'nowhere' is not HOST:PORT\n");
}

TEST_F(RunTest, OptionsOfTheEmbeddedServiceAreNotSilentlyDropped) {
  const Outcome outcome = Run({"server", "info", "--threads", "2", "--data-dir", "/tmp"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.err, HasSubstr("celt: --threads: ignored"));
  EXPECT_THAT(outcome.err, HasSubstr("celt: --data-dir: ignored"));
}

/// The fake as a service in this process.
class Embedded : public cli::EmbeddedService {
 public:
  explicit Embedded(FakeService& service) : service_(service) {}
  std::shared_ptr<grpc::Channel> channel() override { return service_.InProcessChannel(); }

 private:
  FakeService& service_;
};

using EmbeddedOr = absl::StatusOr<std::unique_ptr<cli::EmbeddedService>>;

TEST_F(RunTest, EmbeddedServiceGetsItsOptionsAndIsSpokenToInProcess) {
  service_.scripts = {Answer()};
  cli::EmbeddedOptions got;
  const auto start = [&](const cli::EmbeddedOptions& options) -> EmbeddedOr {
    got = options;
    return std::make_unique<Embedded>(service_);
  };
  const Outcome outcome =
      RunCelt({"lyapunov", "--threads", "2", "--data-dir", "/data"}, {.start_embedded = start});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(got.threads, 2);
  EXPECT_EQ(got.data_dir, "/data");
  const Outcome defaults = RunCelt({"lyapunov"}, {.start_embedded = start});
  EXPECT_EQ(got.threads, std::nullopt);
  EXPECT_EQ(got.data_dir, "/nonexistent");
  EXPECT_EQ(defaults.out, Run({"lyapunov"}).out);
}

TEST_F(RunTest, DefaultDataDirectoryInUseDoesNotStopAComputation) {
  service_.scripts = {Answer()};
  const auto start = [&](const cli::EmbeddedOptions& options) -> EmbeddedOr {
    if (!options.data_dir.empty()) return absl::UnavailableError("data directory: in use");
    return std::make_unique<Embedded>(service_);
  };
  const Outcome computed = RunCelt({"lyapunov"}, {.start_embedded = start});
  EXPECT_EQ(computed.code, 0);
  EXPECT_EQ(computed.err, "celt: data directory: in use; this job is kept in memory only\n");
  const Outcome named = RunCelt({"lyapunov", "--data-dir", "/x"}, {.start_embedded = start});
  EXPECT_EQ(named.code, 3);
  const Outcome listed = RunCelt({"jobs", "list"}, {.start_embedded = start});
  EXPECT_EQ(listed.code, 3);
  EXPECT_THAT(listed.err, StartsWith("celt: data directory: in use; wait for it to end"));
  EXPECT_THAT(listed.err, HasSubstr("--server"));
}

TEST_F(RunTest, EmbeddedServiceThatCannotStartSaysWhy) {
  const auto start = [](const cli::EmbeddedOptions& /*options*/) -> EmbeddedOr {
    return absl::DataLossError("the store is corrupt");
  };
  const Outcome outcome = RunCelt({"lyapunov"}, {.start_embedded = start});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(outcome.err, "celt: the store is corrupt\n");
}

struct SubmitCase {
  grpc::StatusCode code;
  int exit_code;
};

TEST_F(RunTest, RefusedSubmissionExitsByTheContract) {
  using enum grpc::StatusCode;
  for (const auto& [code, exit_code] : std::vector<SubmitCase>{{INVALID_ARGUMENT, 2},
                                                               {ALREADY_EXISTS, 2},
                                                               {UNAVAILABLE, 3},
                                                               {PERMISSION_DENIED, 3},
                                                               {UNAUTHENTICATED, 3},
                                                               {RESOURCE_EXHAUSTED, 3},
                                                               {UNIMPLEMENTED, 3},
                                                               {INTERNAL, 1}}) {
    service_.submit_status = {code, "energy: 1 is below 100"};
    const Outcome outcome = Run({"lyapunov"});
    EXPECT_EQ(outcome.code, exit_code) << code;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, StartsWith("celt: "));
    EXPECT_THAT(outcome.err, HasSubstr("energy: 1 is below 100\n"));
  }
}

TEST_F(RunTest, JobThatEndsWithoutAnswerExitsOneAndKeepsItsRecords) {
  for (const auto code : {grpc::StatusCode::FAILED_PRECONDITION, grpc::StatusCode::ABORTED}) {
    service_.scripts = {{{RecordMessage(1)}, {code, "job job-1 failed: orbit lost"}}};
    const Outcome outcome = Run({"lyapunov"});
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err, "celt: job job-1 failed: orbit lost\n");
    EXPECT_THAT(outcome.out, StartsWith("{\"sequence\":\"1\""));
  }
}

TEST_F(RunTest, ServerThatIsNotThereIsSaidInOneLine) {
  std::string address;
  { address = FakeService().address(); }
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"lyapunov"}, {"jobs", "list"}, {"jobs", "results", "x"}, {"jobs", "watch", "x"}}) {
    const Outcome outcome = RunCelt(arguments, {.server = address});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, StartsWith("celt: server " + address + ": unavailable: "));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
  }
}

TEST_F(RunTest, ServerThatGoesAwayForGoodIsNotWaitedForBeyondThePatience) {
  service_.scripts = {{{RecordMessage(1)}, {grpc::StatusCode::UNAVAILABLE, "shutting down"}}};
  const Outcome outcome = Run({"lyapunov", "--reconnect", "0"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("shutting down"));
}

TEST_F(RunTest, ProgressIsShownOnATerminalAndErased) {
  service_.scripts = {{{ResultMessage()}, {}}};
  v1::Job half = service_.job;
  half.mutable_progress()->set_done(1);
  half.mutable_progress()->set_total(2);
  service_.watched = {half};
  const Outcome outcome = RunCelt({"jobs", "watch", "job-1", "--reconnect", "0"},
                                  {.server = service_.address(), .progress_width = 80});
  EXPECT_THAT(outcome.err, StartsWith("\r\x1b[K[############------------]  50%\r\x1b[K"));
}

TEST_F(RunTest, ResultsStartAfterTheRecordAskedFor) {
  service_.scripts = {{{RecordMessage(6), ResultMessage()}, {}}};
  const Outcome outcome = Run({"jobs", "results", "job-1", "--after", "5"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(service_.resumed_after(), (std::vector<std::int64_t>{5}));
  EXPECT_THAT(outcome.out, StartsWith("{\"sequence\":\"6\""));
}

TEST_F(RunTest, ListFollowsThePagesUpToTheLimit) {
  const std::string line =
      R"({"job":{"id":"job-1","state":"STATE_RUNNING","spec":{"system":{"name":"celtic-stone",)"
      R"("parameters":{"energy":752}},"lyapunov":{}}}})"
      "\n";
  EXPECT_EQ(Run({"jobs", "list"}).out, line + line);
  EXPECT_EQ(Run({"jobs", "list", "--limit", "1"}).out, line);
  EXPECT_EQ(Run({"jobs", "list", "--limit", "0"}).code, 2);
}

TEST_F(RunTest, JobIsShownAsCsvAndTable) {
  EXPECT_EQ(Run({"jobs", "get", "job-1", "--output", "csv"}).out,
            "id,state,analysis,system,progress,records,created,ended,error\n"
            "job-1,running,lyapunov,celtic-stone at energy 752,,0,,,\n");
  EXPECT_EQ(Run({"jobs", "get", "job-1", "--output", "table"}).out,
            "  id        job-1\n  state     running\n  analysis  lyapunov\n"
            "  system    celtic-stone at energy 752\n  records   0\n");
}

TEST_F(RunTest, WatchPrintsEveryUpdateAndExitsByTheState) {
  service_.watched = {service_.job, service_.job};
  service_.watched[1].set_state(v1::Job::STATE_SUCCEEDED);
  const Outcome succeeded = Run({"jobs", "watch", "job-1"});
  EXPECT_EQ(succeeded.code, 0);
  EXPECT_EQ(std::count(succeeded.out.begin(), succeeded.out.end(), '\n'), 2);
  service_.watched[1].set_state(v1::Job::STATE_CANCELLED);
  EXPECT_EQ(Run({"jobs", "watch", "job-1"}).code, 1);
}

TEST_F(RunTest, CancelAndDelete) {
  const Outcome cancelled = Run({"jobs", "cancel", "job-1"});
  EXPECT_EQ(cancelled.code, 0);
  EXPECT_THAT(cancelled.out, HasSubstr("STATE_CANCELLED"));
  EXPECT_TRUE(service_.cancelled());
  const Outcome deleted = Run({"jobs", "delete", "job-1"});
  EXPECT_EQ(deleted.code, 0);
  EXPECT_EQ(deleted.out, "");
}

TEST_F(RunTest, JobThatDoesNotExistIsAWrongCommandLine) {
  for (const char* verb : {"get", "watch", "results", "cancel", "delete"}) {
    const Outcome outcome = Run({"jobs", verb, "other"});
    EXPECT_EQ(outcome.code, 2) << verb;
    EXPECT_EQ(outcome.err, "celt: id: no job 'other'\n") << verb;
  }
}

TEST_F(RunTest, ServerInfoInAllFormats) {
  EXPECT_THAT(Run({"server", "info"}).out, StartsWith("{\"info\":{\"version\":\"9.9.9\","));
  EXPECT_EQ(Run({"server", "info", "--output", "csv"}).out,
            "system,parameter,default,unit,range,description\n"
            "henon3d,b,0.7,,\"(-inf, inf)\",\"Jacobian, in words: constant\"\n");
  EXPECT_THAT(Run({"server", "info", "--output", "table"}).out,
              StartsWith("celt 9.9.9, engine version 7, 2 workers\n"
                         "  computes  lyapunov, sweep\n"
                         "  by        arkode, fast\n\n"
                         "  at most\n"
                         "  nodes of a sweep    10 000\n"
                         "  computing of a job  2:00:00\n\n"
                         "henon3d: Three-dimensional Hénon map\n"));
}

}  // namespace
}  // namespace celt
