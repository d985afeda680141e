#include <stop_token>

#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt {
namespace {

/// A service whose job waits to be cancelled, and a Ctrl-C once it does.
class InterruptTest : public ::testing::Test {
 protected:
  InterruptTest() {
    service_.scripts = {
        {{RecordMessage(1)}, {grpc::StatusCode::ABORTED, "the job was cancelled"}, true}};
    service_.on_waiting = [this] { interrupt_.request_stop(); };
  }

  Outcome Run(const std::vector<std::string>& arguments) {
    return RunCelt(arguments, {.server = service_.address(), .interrupt = interrupt_.get_token()});
  }

  std::stop_source interrupt_;
  FakeService service_;
};

TEST_F(InterruptTest, CancelsTheJobThatIsComputed) {
  const Outcome outcome = Run({"lyapunov"});
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.err, "celt: interrupted: job job-1 is cancelled\n");
  EXPECT_TRUE(service_.cancelled());
}

TEST_F(InterruptTest, DuringTheSubmissionCancelsTheJobAsWell) {
  interrupt_.request_stop();
  EXPECT_EQ(Run({"lyapunov"}).code, 130);
  EXPECT_TRUE(service_.cancelled());
}

TEST_F(InterruptTest, DoesNotWaitForAServerThatDoesNotCancel) {
  service_.cancel_status = {grpc::StatusCode::INTERNAL, "disk"};
  const Outcome outcome = Run({"lyapunov"});
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.err,
            "celt: interrupted: job job-1 may go on, it could not be cancelled: disk\n");
}

TEST_F(InterruptTest, LeavesAJobThatIsOnlyLookedAt) {
  const Outcome outcome = Run({"jobs", "results", "job-1"});
  EXPECT_EQ(outcome.code, 130);
  EXPECT_EQ(outcome.err, "celt: interrupted\n");
  EXPECT_FALSE(service_.cancelled());
}

TEST_F(InterruptTest, EndsCallsWithOneAnswer) {
  interrupt_.request_stop();
  EXPECT_EQ(Run({"jobs", "list"}).code, 130);
  EXPECT_EQ(Run({"server", "info"}).code, 130);
}

}  // namespace
}  // namespace celt
