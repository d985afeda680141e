// What a server is told, what it tells of itself, and how it goes.

#include <chrono>
#include <csignal>
#include <fstream>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "grpcpp/grpcpp.h"
#include "gtest/gtest.h"
#include "httplib.h"
#include "tests/e2e/daemon.h"

namespace celt {
namespace {

using ::testing::HasSubstr;

using Arguments = std::vector<std::string>;

class ServerTest : public ::testing::Test {
 protected:
  std::string WriteConfig(const std::string& text) const {
    std::ofstream(directory_.path() + "/celtd.toml") << text;
    return directory_.path() + "/celtd.toml";
  }
  Ended Check(const Arguments& arguments) const {
    return Process(CELTD_PROGRAM, With(arguments, {"--check"})).Wait();
  }

  TemporaryDirectory directory_;
  Celt celt_;
};

TEST_F(ServerTest, NamesTheLineOfAConfigurationThatIsWrong) {
  const std::string file = WriteConfig("workers = 2\n[limits]\nnodez = 5\n");
  const Ended run = Check({"--config", file});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.err, "celtd: " + file + ":3: limits.nodez: there is no such setting\n");
}

TEST_F(ServerTest, FlagsWinOverTheFile) {
  const std::string file = WriteConfig("workers = 1\nlisten = 'nowhere'\n");
  EXPECT_EQ(Check({"--config", file}).code, 2);
  const Ended run = Check({"--config", file, "--listen", "127.0.0.1:0"});
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(ServerTest, TheExampleOfAConfigurationIsAsTheDefaultsAre) {
  const Ended run = Check({"--config", CELT_EXAMPLE_CONFIG});
  EXPECT_EQ(run.code, 0) << run.err;
}

TEST_F(ServerTest, WaitsForTheDiskAsItIsTold) {
  const auto metrics = [&](const Arguments& arguments) {
    const Daemon daemon(directory_.path() + "/data", 1, "127.0.0.1:0", arguments);
    return httplib::Client("http://" + daemon.http()).Get("/metrics")->body;
  };
  EXPECT_THAT(metrics({}), HasSubstr("celt_store_synchronous 1\n"));
  EXPECT_THAT(metrics({"--store-synchronous", "full"}), HasSubstr("celt_store_synchronous 2\n"));
}

TEST_F(ServerTest, RefusesWhatItsLimitsForbid) {
  const std::string file = WriteConfig("[limits]\niterates = 5000\nunfinished_jobs = 1\n");
  const Daemon daemon(directory_.path() + "/data", 1, "127.0.0.1:0", {"--config", file});
  const auto run = [&](const Arguments& more) {
    return celt_.Run(With({"lyapunov", "--system", "henon3d", "--transient", "0", "--orbits", "1",
                           "--server", daemon.address(), "--detach"},
                          more));
  };
  const Ended large = run({"--iterates", "5001"});
  EXPECT_EQ(large.code, 2);
  EXPECT_THAT(large.err, HasSubstr("lyapunov.iterates: 5001 iterates are more than this server's"));
  EXPECT_EQ(run({"--iterates", "5000"}).code, 0);
}

TEST_F(ServerTest, TellsPrometheusAndProbesHowItIs) {
  const Daemon daemon(directory_.path(), 2);
  ASSERT_EQ(celt_
                .Run({"lyapunov", "--system", "henon3d", "--iterates", "1000", "--server",
                      daemon.address()})
                .code,
            0);
  httplib::Client http("http://" + daemon.http());
  const std::string text = http.Get("/metrics")->body;
  EXPECT_THAT(text, HasSubstr("celt_jobs{state=\"succeeded\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("celt_calls_total{code=\"OK\",method=\"SubmitJob\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("celt_work_total{unit=\"iterates\"}"));
  EXPECT_THAT(text, HasSubstr("celt_store_bytes"));
  EXPECT_EQ(http.Get("/livez")->status, 200);
  EXPECT_EQ(http.Get("/readyz")->status, 200);
}

/// A stream with more to read than fits on its way, of which one record is read: it can't be ended
/// before its client reads on.
struct StalledReader {
  explicit StalledReader(const Daemon& daemon) : stub(daemon.Connect()) {
    v1::SubmitJobRequest submission;
    submission.mutable_spec()->mutable_system()->set_name("henon3d");
    submission.mutable_spec()->mutable_section()->set_iterates(300'000);
    grpc::ClientContext submitting;
    v1::Job job;
    EXPECT_TRUE(stub->SubmitJob(&submitting, submission, &job).ok());
    grpc::ClientContext watching;
    v1::WatchJobRequest watched;
    watched.set_id(job.id());
    const auto watch = stub->WatchJob(&watching, watched);
    while (watch->Read(&job)) {
    }
    EXPECT_EQ(job.state(), v1::Job::STATE_SUCCEEDED);
    v1::StreamResultsRequest request;
    request.set_id(job.id());
    reader = stub->StreamResults(&context, request);
    v1::StreamResultsResponse first;
    EXPECT_TRUE(reader->Read(&first));
  }
  ~StalledReader() {
    context.TryCancel();
    static_cast<void>(reader->Finish());
  }

  /// Returns once the server takes no more jobs, or is gone: it has seen the signal.
  void AwaitDraining() const {
    for (grpc::Status status; status.error_code() != grpc::StatusCode::UNAVAILABLE;) {
      grpc::ClientContext submitting;
      v1::SubmitJobRequest submission;
      submission.mutable_spec()->mutable_system()->set_name("henon3d");
      submission.mutable_spec()->mutable_section()->set_iterates(10);
      v1::Job job;
      status = stub->SubmitJob(&submitting, submission, &job);
    }
  }

  std::unique_ptr<v1::Celt::Stub> stub;
  grpc::ClientContext context;
  std::unique_ptr<grpc::ClientReader<v1::StreamResultsResponse>> reader;
};

TEST_F(ServerTest, DrainsInItsTimeAlthoughAClientDoesNotRead) {
  Daemon daemon(directory_.path(), 2, "127.0.0.1:0", {"--drain-seconds", "0.2"});
  const StalledReader stalled(daemon);
  daemon.process().Signal(SIGTERM);
  EXPECT_EQ(daemon.process().Wait().code, 0);
}

TEST_F(ServerTest, ASecondSignalEndsItAtOnce) {
  Daemon daemon(directory_.path(), 2, "127.0.0.1:0", {"--drain-seconds", "10000"});
  const StalledReader stalled(daemon);
  daemon.process().Signal(SIGTERM);
  stalled.AwaitDraining();
  daemon.process().Signal(SIGTERM);
  EXPECT_EQ(daemon.process().Wait().code, 128 + SIGTERM);
}

/// More of a log than a pipe holds, which nobody reads.
TEST_F(ServerTest, WorksOnWhileNobodyReadsItsLog) {
  Daemon daemon(directory_.path());
  const auto stub = daemon.Connect();
  for (int call = 0; call < 150; ++call) {
    grpc::ClientContext context;
    // Met only by a server that hangs.
    context.set_deadline(std::chrono::system_clock::now() + std::chrono::seconds(60));
    v1::GetJobRequest request;
    request.set_id(std::string(2000, 'x'));
    v1::Job job;
    ASSERT_EQ(stub->GetJob(&context, request, &job).error_code(), grpc::StatusCode::NOT_FOUND);
  }
  daemon.process().Signal(SIGTERM);
  const Ended ended = daemon.process().Wait();
  EXPECT_EQ(ended.code, 0);
  EXPECT_LE(ended.err.size(), 65536 + 4096);
}

}  // namespace
}  // namespace celt
