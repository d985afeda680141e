// A server is killed at random moments under a mixed load: every job that was accepted ends, and
// its stream is byte for byte that of a server that was left alone. `tests/e2e/crash` does it more
// often.

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "google/protobuf/text_format.h"
#include "grpcpp/grpcpp.h"
#include "gtest/gtest.h"
#include "tests/e2e/daemon.h"

namespace celt {
namespace {

/// A chain, a few chains, many chains, one that follows, and one that fails.
const std::vector<std::string>& Questions() {
  static const auto& questions = *new std::vector<std::string>{
      "system { name: 'henon3d' } section { iterates: 20000 }",
      "system { name: 'henon3d' } lyapunov { iterates: 200000 orbits: 6 }",
      "lyapunov { iterates: 320 orbits: 4 transient: 50 }",
      "system { name: 'henon3d' } sweep { axes { parameter: 'm2' from: 0.8 to: 0.85 nodes: 40 } "
      "lyapunov { iterates: 4000 orbits: 2 } }",
      "system { name: 'henon3d' } sweep { follow: true "
      "axes { parameter: 'm2' from: 0.8 to: 0.85 nodes: 12 } section { iterates: 2000 } }",
      "system { name: 'henon3d' } section { iterates: 100 start { x: [50, 50, 50] } }"};
  return questions;
}

int Crashes() {
  constexpr int kFew = 10;
  const char* const asked = std::getenv("CELT_CRASHES");
  return asked == nullptr ? kFew : std::atoi(asked);
}

v1::SubmitJobRequest RequestFor(std::size_t question, const std::string& request_id) {
  v1::SubmitJobRequest request;
  EXPECT_TRUE(
      google::protobuf::TextFormat::ParseFromString(Questions()[question], request.mutable_spec()));
  request.set_request_id(request_id);
  request.set_fresh(true);
  return request;
}

/// All that a job's stream says, its end included.
std::string Answer(v1::Celt::Stub& stub, const std::string& id) {
  grpc::ClientContext context;
  v1::StreamResultsRequest request;
  request.set_id(id);
  const auto reader = stub.StreamResults(&context, request);
  std::string answer;
  for (v1::StreamResultsResponse message; reader->Read(&message);) {
    answer += message.SerializeAsString();
  }
  const grpc::Status status = reader->Finish();
  // The message of a job that failed names it.
  return answer + "/" + std::to_string(status.error_code());
}

std::string Submit(v1::Celt::Stub& stub, const v1::SubmitJobRequest& request) {
  grpc::ClientContext context;
  v1::Job job;
  return stub.SubmitJob(&context, request, &job).ok() ? job.id() : "";
}

class CrashTest : public ::testing::Test {
 protected:
  /// One life: the daemon is killed after `life`, while jobs are submitted.
  void LiveAndDie(std::chrono::microseconds life) {
    Daemon daemon(data_.path());
    const auto stub = daemon.Connect();
    const std::jthread killer([&] {
      // The moment of death is what the test is about; nothing waits for it.
      std::this_thread::sleep_for(life);
      daemon.process().Signal(SIGKILL);
    });
    for (int i = 0; i < kJobsInALife; ++i) {
      const std::size_t question = next_ % Questions().size();
      const std::string request_id = "request-" + std::to_string(next_);
      const std::string id = Submit(*stub, RequestFor(question, request_id));
      // Of what was cut off nobody knows whether it was accepted: it is asked again, next time.
      if (id.empty()) break;
      accepted_[id] = question;
      ++next_;
    }
  }

  static constexpr int kJobsInALife = 3;
  TemporaryDirectory data_;
  std::size_t next_ = 0;
  std::map<std::string, std::size_t> accepted_;  // questions by the ids of their jobs
};

TEST_F(CrashTest, LosesNothingAndComputesNothingTwice) {
  std::vector<std::string> expected;
  {
    const TemporaryDirectory data;
    const Daemon left_alone(data.path());
    const auto stub = left_alone.Connect();
    for (std::size_t question = 0; question < Questions().size(); ++question) {
      expected.push_back(Answer(*stub, Submit(*stub, RequestFor(question, ""))));
    }
  }
  std::mt19937 random(1);
  std::uniform_int_distribution<int> life(1'000, 300'000);
  for (int i = 0; i < Crashes(); ++i) LiveAndDie(std::chrono::microseconds(life(random)));
  const Daemon last(data_.path());
  const auto stub = last.Connect();
  for (const auto& [id, question] : accepted_) {
    // Not EXPECT_EQ, which would print both.
    EXPECT_TRUE(Answer(*stub, id) == expected[question]) << id << ": " << Questions()[question];
  }
  EXPECT_GT(accepted_.size(), Questions().size());
  std::printf("%d crashes, %zu jobs\n", Crashes(), accepted_.size());
}

}  // namespace
}  // namespace celt
