// Nothing hangs: neither at Ctrl-C in the client, nor when the server is told to go.

#include <algorithm>
#include <csignal>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "grpcpp/grpcpp.h"
#include "gtest/gtest.h"
#include "tests/e2e/daemon.h"

namespace celt {
namespace {

using ::testing::HasSubstr;

using Arguments = std::vector<std::string>;

/// Far longer than any test, with a first record soon: one comes every few ten thousand iterates.
const Arguments kLong = {"lyapunov", "--system", "henon3d", "--iterates", "3e7"};

class SignalsTest : public ::testing::Test {
 protected:
  Arguments Remote(const Arguments& arguments) const {
    return With(arguments, {"--server", daemon_->address()});
  }

  /// Starts celt, and returns once its job computes and its stream is open.
  std::unique_ptr<Process> StartAndReadARecord(const Arguments& arguments) const {
    auto process = celt_.Start(arguments);
    EXPECT_THAT(process->ReadLine(), HasSubstr("\"sequence\":\"1\""));
    return process;
  }

  v1::Job OnlyJob() const {
    grpc::ClientContext context;
    v1::ListJobsResponse jobs;
    const grpc::Status status = daemon_->Connect()->ListJobs(&context, {}, &jobs);
    EXPECT_TRUE(status.ok()) << status.error_message();
    EXPECT_EQ(jobs.jobs_size(), 1);
    return jobs.jobs_size() == 1 ? jobs.jobs(0) : v1::Job();
  }

  /// The state in which the only job ends.
  v1::Job::State EndOfOnlyJob() const {
    grpc::ClientContext context;
    v1::WatchJobRequest request;
    request.set_id(OnlyJob().id());
    const auto stub = daemon_->Connect();
    const auto reader = stub->WatchJob(&context, request);
    v1::Job job;
    while (reader->Read(&job)) {
    }
    EXPECT_TRUE(reader->Finish().ok());
    return job.state();
  }

  TemporaryDirectory data_;
  std::unique_ptr<Daemon> daemon_ = std::make_unique<Daemon>(data_.path());
  Celt celt_;
};

TEST_F(SignalsTest, CtrlCCancelsTheJobAtTheServer) {
  const auto celt = StartAndReadARecord(Remote(kLong));
  celt->Signal(SIGINT);
  const Ended ended = celt->Wait();
  EXPECT_EQ(ended.code, 130);
  EXPECT_THAT(ended.err, HasSubstr("celt: interrupted: job "));
  EXPECT_EQ(EndOfOnlyJob(), v1::Job::STATE_CANCELLED);
}

/// The records and the result of an embedded run that was ended by a signal after a record, and
/// then run again.
Ended InterruptedAndRunAgain(const Celt& celt, const Arguments& question, int signal) {
  const auto first = celt.Start(question);
  EXPECT_THAT(first->ReadLine(), HasSubstr("\"sequence\":\"1\""));
  first->Signal(signal);
  EXPECT_EQ(first->Wait().code, signal == SIGKILL ? 128 + SIGKILL : 130);
  EXPECT_THAT(celt.Run({"jobs", "list"}).out, HasSubstr("\"state\":\"STATE_RUNNING\""));
  return celt.Run(question);
}

TEST_F(SignalsTest, EmbeddedRunThatWasInterruptedOrKilledGoesOnWhenRunAgain) {
  const Arguments question = {"lyapunov", "--system", "henon3d", "--iterates", "2e6"};
  const std::string expected = Celt().Run(question).out;
  for (const int signal : {SIGINT, SIGTERM, SIGKILL}) {
    const Celt celt;
    const Ended ended = InterruptedAndRunAgain(celt, question, signal);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_TRUE(ended.out == expected) << "signal " << signal;
    const std::string jobs = celt.Run({"jobs", "list"}).out;
    EXPECT_EQ(std::count(jobs.begin(), jobs.end(), '\n'), 1) << "not a second job: " << jobs;
  }
}

TEST_F(SignalsTest, CtrlCInAReaderLeavesTheJob) {
  const Ended detached = celt_.Run(Remote(With(kLong, {"--detach", "--output", "table"})));
  const std::string id = detached.out.substr(0, detached.out.find('\n'));
  const auto reader = StartAndReadARecord(Remote({"jobs", "results", id}));
  reader->Signal(SIGINT);
  EXPECT_EQ(reader->Wait().code, 130);
  EXPECT_EQ(OnlyJob().state(), v1::Job::STATE_RUNNING);
}

TEST_F(SignalsTest, CtrlCDoesNotWaitForAServerThatHangs) {
  const auto celt = StartAndReadARecord(Remote(kLong));
  daemon_->process().Signal(SIGSTOP);
  celt->Signal(SIGINT);
  const Ended ended = celt->Wait();
  daemon_->process().Signal(SIGCONT);
  EXPECT_EQ(ended.code, 130);
}

TEST_F(SignalsTest, JobWhoseOutputNobodyReadsIsCancelled) {
  const auto celt = StartAndReadARecord(Remote(kLong));
  celt->CloseOutput();
  const Ended ended = celt->Wait();
  EXPECT_EQ(ended.code, 1);
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(EndOfOnlyJob(), v1::Job::STATE_CANCELLED);
}

/// Opens a stream of the job, calls `when_open` after its first message, and reads it to its end.
/// The connection ends with it: an idle one is looked at by gRPC every five seconds only, and so
/// long a server that says goodbye waits for its answer.
grpc::StatusCode EndOfStream(const Daemon& daemon, const std::string& id,
                             const std::function<void()>& when_open) {
  const auto stub = daemon.Connect();
  grpc::ClientContext context;
  v1::StreamResultsRequest request;
  request.set_id(id);
  const auto reader = stub->StreamResults(&context, request);
  v1::StreamResultsResponse message;
  EXPECT_TRUE(reader->Read(&message));
  when_open();
  while (reader->Read(&message)) {
  }
  return reader->Finish().error_code();
}

TEST_F(SignalsTest, ServerEndsInTimeWithAJobRunningAndStreamsOpen) {
  const auto celt = StartAndReadARecord(Remote(With(kLong, {"--reconnect", "0"})));
  const auto code =
      EndOfStream(*daemon_, OnlyJob().id(), [this] { daemon_->process().Signal(SIGTERM); });
  EXPECT_EQ(code, grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(daemon_->process().Wait().code, 0);
  EXPECT_EQ(celt->Wait().code, 3);
}

TEST_F(SignalsTest, ClientDoesNotNoticeThatTheServerIsStartedAnew) {
  const Arguments question = {"lyapunov", "--system", "henon3d", "--iterates", "2e6"};
  const auto celt = celt_.Start(Remote(question));
  const std::string first = celt->ReadLine();
  const std::string address = daemon_->address();
  daemon_->process().Signal(SIGTERM);
  EXPECT_EQ(daemon_->process().Wait().code, 0);
  daemon_.reset();
  daemon_ = std::make_unique<Daemon>(data_.path(), 2, address);
  const Ended ended = celt->Wait();
  EXPECT_EQ(ended.code, 0) << ended.err;
  // Not EXPECT_EQ, which would print both.
  EXPECT_TRUE(first + "\n" + ended.out == celt_.Run(question).out);
}

TEST_F(SignalsTest, TwoEmbeddedRunsSideBySideBothCompute) {
  const auto first = StartAndReadARecord(kLong);
  const Ended second = celt_.Run({"lyapunov", "--system", "henon3d", "--iterates", "1000"});
  EXPECT_EQ(second.code, 0) << second.err;
  EXPECT_THAT(second.err, HasSubstr("in use"));
  first->Signal(SIGTERM);
  EXPECT_EQ(first->Wait().code, 130);
}

}  // namespace
}  // namespace celt
