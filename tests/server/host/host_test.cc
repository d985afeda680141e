#include "server/host/host.h"

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/synchronization/notification.h"
#include "gmock/gmock.h"
#include "grpcpp/create_channel.h"
#include "grpcpp/generic/generic_stub.h"
#include "gtest/gtest.h"
#include "host/host_testing.h"
#include "httplib.h"
#include "server/api/error_details.pb.h"
#include "temporary_directory.h"

namespace celt::host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

/// Asks the standard health service about "celt.v1.Celt", in bytes: its C++ stub is no part of
/// Debian.
std::string AskHealth(Host& host) {
  grpc::GenericStub stub(host.InProcessChannel());
  const grpc::Slice question(
      "\x0a\x0c"
      "celt.v1.Celt");
  const grpc::ByteBuffer request(&question, 1);
  grpc::ByteBuffer response;
  grpc::ClientContext context;
  grpc::Status status;
  absl::Notification done;
  stub.UnaryCall(&context, "/grpc.health.v1.Health/Check", {}, &request, &response,
                 [&](grpc::Status its_status) {
                   status = its_status;
                   done.Notify();
                 });
  done.WaitForNotification();
  EXPECT_TRUE(status.ok()) << status.error_message();
  grpc::Slice answer;
  EXPECT_TRUE(response.DumpToSingleSlice(&answer).ok());
  return {answer.begin(), answer.end()};
}

TEST(Host, TellsHealthChecksThatItServes) {
  const auto host = StartHost();
  EXPECT_EQ(AskHealth(*host), "\x08\x01");  // status: SERVING
}

/// What a health check that watches is told before and while a host drains; empty when nothing.
std::vector<std::string> WatchHealthOverADrain() {
  const auto host = StartHost();
  grpc::GenericStub stub(host->InProcessChannel());
  grpc::CompletionQueue queue;
  const auto next = [&queue] {
    void* tag = nullptr;
    bool ok = false;
    return queue.Next(&tag, &ok) && ok;
  };
  grpc::ClientContext context;
  const auto watch = stub.PrepareCall(&context, "/grpc.health.v1.Health/Watch", &queue);
  watch->StartCall(nullptr);
  next();
  const grpc::Slice question(
      "\x0a\x0c"
      "celt.v1.Celt");
  watch->WriteLast(grpc::ByteBuffer(&question, 1), {}, nullptr);
  next();
  const auto read = [&] {
    grpc::ByteBuffer answer;
    grpc::Slice bytes;
    watch->Read(&answer, nullptr);
    if (!next() || !answer.DumpToSingleSlice(&bytes).ok()) return std::string();
    return std::string(bytes.begin(), bytes.end());
  };
  std::vector<std::string> told = {read()};
  std::thread drain([&] { host->Drain(absl::InfiniteDuration()); });
  told.push_back(read());
  context.TryCancel();
  grpc::Status status;
  watch->Finish(&status, nullptr);
  next();
  drain.join();
  return told;
}

TEST(Host, TellsHealthChecksThatItServesNoMoreWhileItDrains) {
  // gRPC says nothing to one whose first answer is still on its way within the server.
  constexpr int kTries = 10;
  std::vector<std::string> told;
  for (int i = 0; i < kTries && (told.empty() || told.back().empty()); ++i) {
    told = WatchHealthOverADrain();
  }
  EXPECT_THAT(told, ElementsAre("\x08\x01", "\x08\x02"));  // SERVING, NOT_SERVING
}

TEST(Host, IsAliveButNotReadyOnceItDrains) {
  HostOptions options;
  options.http = "127.0.0.1:0";
  const auto host = Host::Start(options);
  ASSERT_TRUE(host.ok()) << host.status();
  httplib::Client http("http://" + (*host)->http_address());
  EXPECT_EQ(http.Get("/readyz")->status, 200);
  (*host)->Drain(absl::ZeroDuration());
  EXPECT_EQ(http.Get("/readyz")->status, 503);
  EXPECT_EQ(http.Get("/livez")->status, 200);
}

/// Asks until the answer is what it is to become; it becomes that soon, or the host is broken.
template <class Ask>
bool Becomes(grpc::StatusCode code, Ask ask) {
  constexpr int kPatience = 10'000;
  for (int i = 0; i < kPatience; ++i) {
    if (ask().error_code() == code) return true;
    std::this_thread::yield();
  }
  return false;
}

TEST(Host, DropsWhatNeedNotBeKept) {
  const TemporaryDirectory temporary;
  HostOptions options;
  options.data_dir = temporary.path();
  std::string id;
  const auto start = [&](std::unique_ptr<Host>& host) {
    host.reset();
    auto started = Host::Start(options);
    ASSERT_TRUE(started.ok()) << started.status();
    host = *std::move(started);
  };
  std::unique_ptr<Host> host;
  start(host);
  auto stub = v1::Celt::NewStub(host->InProcessChannel());
  id = Submit(*stub, kShort).id();
  ASSERT_TRUE(Results(*stub, id).ReadAll().ok());

  options.retention.records = absl::ZeroDuration();
  start(host);
  stub = v1::Celt::NewStub(host->InProcessChannel());
  const auto read = [&](std::int64_t after) { return Results(*stub, id, after).ReadAll(); };
  EXPECT_TRUE(Becomes(grpc::StatusCode::OUT_OF_RANGE, [&] { return read(0); }));
  EXPECT_TRUE(read(64).ok()) << "the result is kept";

  options.retention.jobs = absl::ZeroDuration();
  start(host);
  stub = v1::Celt::NewStub(host->InProcessChannel());
  v1::Job job;
  EXPECT_TRUE(Becomes(grpc::StatusCode::NOT_FOUND, [&] { return Get(*stub, id, &job); }));
}

TEST(Host, SaysWhenToComeBackWhenItsQueueIsFull) {
  HostOptions options;
  options.job_limits.unfinished = 1;
  const auto host = Host::Start(options);
  ASSERT_TRUE(host.ok()) << host.status();
  const auto stub = v1::Celt::NewStub((*host)->InProcessChannel());
  Submit(*stub, kEndless);
  const grpc::Status full = TrySubmit(*stub, kShort);
  EXPECT_EQ(full.error_code(), grpc::StatusCode::RESOURCE_EXHAUSTED);
  google::rpc::Status details;
  ASSERT_TRUE(details.ParseFromString(full.error_details()));
  google::rpc::RetryInfo retry;
  ASSERT_EQ(details.details_size(), 1);
  ASSERT_TRUE(details.details(0).UnpackTo(&retry));
  EXPECT_GT(retry.retry_delay().seconds(), 0);
}

TEST(Host, ListensOnAFreePortAndSaysWhich) {
  HostOptions options;
  options.listen = "127.0.0.1:0";
  const auto host = Host::Start(options);
  ASSERT_TRUE(host.ok()) << host.status();
  EXPECT_THAT((*host)->address(), ::testing::MatchesRegex("127\\.0\\.0\\.1:[1-9][0-9]*"));
  const auto stub = v1::Celt::NewStub(
      grpc::CreateChannel((*host)->address(), grpc::InsecureChannelCredentials()));
  Results results(*stub, Submit(*stub, kShort).id());
  EXPECT_TRUE(results.ReadAll().ok());
  EXPECT_THAT(results.messages, SizeIs(65));
}

TEST(Host, RefusesAPortInUse) {
  HostOptions options;
  options.listen = "127.0.0.1:0";
  const auto first = Host::Start(options);
  ASSERT_TRUE(first.ok()) << first.status();
  options.listen = (*first)->address();
  const auto second = Host::Start(options);
  EXPECT_EQ(second.status().code(), absl::StatusCode::kFailedPrecondition);
  EXPECT_THAT(std::string(second.status().message()), HasSubstr(options.listen));
}

TEST(Host, RefusesADataDirectoryInUse) {
  const TemporaryDirectory temporary;
  const auto first = StartHost(temporary.path());
  HostOptions options;
  options.data_dir = temporary.path();
  EXPECT_THAT(std::string(Host::Start(options).status().message()), HasSubstr("in use"));
}

TEST(Host, GoesOnAfterARestartAsIfThereHadBeenNone) {
  constexpr const char* kSpec =
      "system { name: 'henon3d' } lyapunov { orbits: 3 iterates: 30001 transient: 100 }";
  std::vector<std::string> expected;
  {
    const auto host = StartHost();
    const auto stub = v1::Celt::NewStub(host->InProcessChannel());
    Results results(*stub, Submit(*stub, kSpec).id());
    EXPECT_TRUE(results.ReadAll().ok());
    expected = results.Bytes();
  }
  const TemporaryDirectory temporary;
  std::string id;
  std::vector<std::string> bytes;
  {
    const auto host = StartHost(temporary.path(), 1);
    const auto stub = v1::Celt::NewStub(host->InProcessChannel());
    id = Submit(*stub, kSpec).id();
    Results results(*stub, id);
    v1::StreamResultsResponse response;
    for (int i = 0; i < 3 && results.reader->Read(&response); ++i) {
      bytes.push_back(response.SerializeAsString());
    }
    results.context.TryCancel();
  }
  const auto host = StartHost(temporary.path(), 2);
  const auto stub = v1::Celt::NewStub(host->InProcessChannel());
  Results rest(*stub, id, 3);
  EXPECT_TRUE(rest.ReadAll().ok());
  for (const std::string& message : rest.Bytes()) bytes.push_back(message);
  EXPECT_EQ(bytes, expected);
}

TEST(Host, EndsOpenStreamsWithUnavailableWhenItDrains) {
  const auto host = StartHost();
  const auto stub = v1::Celt::NewStub(host->InProcessChannel());
  const std::string id = Submit(*stub, kEndless).id();
  Results results(*stub, id);
  grpc::ClientContext context;
  v1::WatchJobRequest request;
  request.set_id(id);
  const auto watch = stub->WatchJob(&context, request);
  v1::Job job;
  ASSERT_TRUE(watch->Read(&job));
  host->Drain(absl::InfiniteDuration());
  while (watch->Read(&job)) {
  }
  EXPECT_EQ(watch->Finish().error_code(), grpc::StatusCode::UNAVAILABLE);
  EXPECT_EQ(results.ReadAll().error_code(), grpc::StatusCode::UNAVAILABLE);
}

TEST(Host, DrainsAlthoughAClientDoesNotRead) {
  const auto host = StartHost();
  const auto stub = v1::Celt::NewStub(host->InProcessChannel());
  const std::string id = Submit(*stub, kShort).id();
  WatchToTheEnd(*stub, id);
  Results stalled(*stub, id);  // has 65 messages to read, and reads none
  v1::StreamResultsResponse response;
  ASSERT_TRUE(stalled.reader->Read(&response)) << "to be sure that the stream is open";
  host->Drain(absl::ZeroDuration());
  EXPECT_FALSE(stalled.ReadAll().ok());
}

TEST(Host, DrainsAlthoughAClientIsGone) {
  const auto host = StartHost();
  const auto stub = v1::Celt::NewStub(host->InProcessChannel());
  const std::string id = Submit(*stub, kEndless).id();
  for (int i = 0; i < 20; ++i) {
    Results dropped(*stub, id);
    dropped.context.TryCancel();
    EXPECT_FALSE(dropped.ReadAll().ok());
  }
  host->Drain(absl::InfiniteDuration());
}

}  // namespace
}  // namespace celt::host
