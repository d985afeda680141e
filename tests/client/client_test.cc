#include "client/client.h"

#include <optional>

#include "gtest/gtest.h"
#include "tests/client/fake_service.h"

namespace celt::client {
namespace {

using Sequences = std::vector<std::int64_t>;

const grpc::Status kUnavailable(grpc::StatusCode::UNAVAILABLE, "shutting down");

/// Reads the stream of the fake's job.
struct Reading {
  explicit Reading(const Client& client, std::int64_t after = 0, const std::stop_token& stop = {}) {
    const auto collect = [this](const v1::Record& record) {
      sequences.push_back(record.sequence());
      return absl::OkStatus();
    };
    result = client.Stream("job-1", after, collect, stop);
  }
  Sequences sequences;
  absl::StatusOr<v1::Result> result;
};

TEST(Client, StreamGivesRecordsThenResult) {
  FakeService service;
  service.scripts = {{{RecordMessage(1), RecordMessage(2), ResultMessage()}, {}}};
  const Client client(OpenChannel(service.address()));
  const Reading reading(client);
  EXPECT_EQ(reading.sequences, (Sequences{1, 2}));
  ASSERT_TRUE(reading.result.ok()) << reading.result.status();
  EXPECT_EQ(reading.result->lyapunov().iterates(), 20000);
}

TEST(Client, StreamGoesOnWhereItBrokeOff) {
  FakeService service;
  service.scripts = {{{RecordMessage(1), RecordMessage(2)}, kUnavailable},
                     {{}, kUnavailable},
                     {{RecordMessage(3), ResultMessage()}, {}}};
  const Client client(OpenChannel(service.address()));
  const Reading reading(client);
  EXPECT_TRUE(reading.result.ok()) << reading.result.status();
  EXPECT_EQ(reading.sequences, (Sequences{1, 2, 3}));
  EXPECT_EQ(service.resumed_after(), (Sequences{0, 2, 2}));
}

TEST(Client, StreamThatTheServerResetsGoesOnToo) {
  FakeService service;
  service.scripts = {{{RecordMessage(1)}, grpc::Status::CANCELLED},
                     {{RecordMessage(2), ResultMessage()}, {}}};
  const Client client(OpenChannel(service.address()));
  const Reading reading(client);
  EXPECT_TRUE(reading.result.ok()) << reading.result.status();
  EXPECT_EQ(reading.sequences, (Sequences{1, 2}));
}

TEST(Client, StreamStartsAfterTheRecordAskedFor) {
  FakeService service;
  service.scripts = {{{RecordMessage(8), ResultMessage()}, {}}};
  const Client client(OpenChannel(service.address()));
  EXPECT_EQ(Reading(client, 7).sequences, (Sequences{8}));
  EXPECT_EQ(service.resumed_after(), (Sequences{7}));
}

TEST(Client, StreamGivesUpWhenPatienceEnds) {
  FakeService service;
  service.scripts = {{{RecordMessage(1)}, kUnavailable}};
  const Client client(OpenChannel(service.address()), {.reconnect = absl::ZeroDuration()});
  EXPECT_EQ(Reading(client).result.status(), absl::UnavailableError("shutting down"));
  EXPECT_EQ(service.resumed_after().size(), 1U);
  service.scripts = {{{}, grpc::Status::CANCELLED}};
  EXPECT_EQ(Reading(client).result.status().code(), absl::StatusCode::kUnavailable);
}

TEST(Client, StreamReportsAGapAsDataLoss) {
  FakeService service;
  service.scripts = {{{RecordMessage(1), RecordMessage(3), ResultMessage()}, {}}};
  const Client client(OpenChannel(service.address()));
  const Reading reading(client);
  EXPECT_EQ(reading.result.status().code(), absl::StatusCode::kDataLoss);
  EXPECT_EQ(reading.sequences, (Sequences{1}));
}

TEST(Client, StreamWithoutResultIsDataLoss) {
  FakeService service;
  service.scripts = {{{RecordMessage(1)}, {}}};
  const Client client(OpenChannel(service.address()));
  EXPECT_EQ(Reading(client).result.status().code(), absl::StatusCode::kDataLoss);
}

TEST(Client, StreamKeepsTheStatusOfAFailedJob) {
  FakeService service;
  service.scripts = {{{}, {grpc::StatusCode::FAILED_PRECONDITION, "orbit 3 left the domain"}}};
  const Client client(OpenChannel(service.address()));
  EXPECT_EQ(Reading(client).result.status(),
            absl::FailedPreconditionError("orbit 3 left the domain"));
}

TEST(Client, StreamEndsWithTheStatusOfItsReader) {
  FakeService service;
  service.scripts = {{{RecordMessage(1)}, {}, true}};
  const Client client(OpenChannel(service.address()));
  const auto refuse = [](const v1::Record&) { return absl::InternalError("disk full"); };
  EXPECT_EQ(client.Stream("job-1", 0, refuse).status(), absl::InternalError("disk full"));
}

TEST(Client, StopEndsAWaitingStream) {
  FakeService service;
  std::stop_source stop;
  service.scripts = {{{RecordMessage(1)}, {}, true}};
  service.on_waiting = [&stop] { stop.request_stop(); };
  const Client client(OpenChannel(service.address()));
  const Reading reading(client, 0, stop.get_token());
  EXPECT_EQ(reading.result.status().code(), absl::StatusCode::kCancelled);
}

TEST(Client, WatchReturnsTheJobAsItEnded) {
  FakeService service;
  service.watched = {service.job, service.job};
  service.watched[1].set_state(v1::Job::STATE_FAILED);
  const Client client(OpenChannel(service.address()));
  int updates = 0;
  const auto count = [&updates](const v1::Job&) {
    ++updates;
    return absl::OkStatus();
  };
  const auto job = client.Watch("job-1", count);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->state(), v1::Job::STATE_FAILED);
  EXPECT_EQ(updates, 2);
}

TEST(Client, StatusOfACallKeepsCodeAndMessage) {
  FakeService service;
  const Client client(OpenChannel(service.address()));
  EXPECT_EQ(client.Get("other").status(), absl::NotFoundError("id: no job 'other'"));
  EXPECT_EQ(client.Delete("other").code(), absl::StatusCode::kNotFound);
}

TEST(Client, ServerThatIsNotThereIsUnavailable) {
  std::string address;
  { address = FakeService().address(); }
  const Client client(OpenChannel(address));
  EXPECT_EQ(client.Info().status().code(), absl::StatusCode::kUnavailable);
}

}  // namespace
}  // namespace celt::client
