#pragma once

#include <memory>
#include <string>
#include <vector>

#include "celt/v1/celt.grpc.pb.h"
#include "google/protobuf/text_format.h"
#include "grpcpp/client_context.h"
#include "gtest/gtest.h"
#include "server/host/host.h"

namespace celt::host {

using Stub = v1::Celt::Stub;

/// A few milliseconds' work, with 64 records.
inline constexpr const char* kShort =
    "system { name: 'henon3d' } lyapunov { orbits: 4 iterates: 25600 transient: 10 }";
/// More than any test waits for.
inline constexpr const char* kEndless =
    "system { name: 'henon3d' } lyapunov { orbits: 4 iterates: 1000000000000 transient: 0 }";
/// Fails in its first unit.
inline constexpr const char* kLost =
    "system { name: 'henon3d' } lyapunov { start { x: [50, 50, 50] } }";

inline std::unique_ptr<Host> StartHost(const std::string& data_dir = "", int workers = 2) {
  HostOptions options;
  options.data_dir = data_dir;
  options.workers = workers;
  auto host = Host::Start(options);
  EXPECT_TRUE(host.ok()) << host.status();
  return host.ok() ? *std::move(host) : nullptr;
}

/// A job of its own, whatever is known already.
inline v1::SubmitJobRequest Request(const std::string& spec, const std::string& request_id = "") {
  v1::SubmitJobRequest request;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(spec, request.mutable_spec())) << spec;
  request.set_request_id(request_id);
  request.set_fresh(true);
  return request;
}

inline v1::Job Submit(Stub& stub, const std::string& spec, const std::string& request_id = "") {
  grpc::ClientContext context;
  v1::Job job;
  const grpc::Status status = stub.SubmitJob(&context, Request(spec, request_id), &job);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return job;
}

inline grpc::Status TrySubmit(Stub& stub, const std::string& spec,
                              const std::string& request_id = "") {
  grpc::ClientContext context;
  v1::Job job;
  return stub.SubmitJob(&context, Request(spec, request_id), &job);
}

inline grpc::Status Get(Stub& stub, const std::string& id, v1::Job* job) {
  grpc::ClientContext context;
  v1::GetJobRequest request;
  request.set_id(id);
  return stub.GetJob(&context, request, job);
}

inline v1::Job Cancel(Stub& stub, const std::string& id) {
  grpc::ClientContext context;
  v1::CancelJobRequest request;
  request.set_id(id);
  v1::Job job;
  const grpc::Status status = stub.CancelJob(&context, request, &job);
  EXPECT_TRUE(status.ok()) << status.error_message();
  return job;
}

inline grpc::Status Delete(Stub& stub, const std::string& id) {
  grpc::ClientContext context;
  v1::DeleteJobRequest request;
  request.set_id(id);
  v1::DeleteJobResponse response;
  return stub.DeleteJob(&context, request, &response);
}

/// A stream of results, read as far as a test likes.
struct Results {
  Results(Stub& stub, const std::string& id, std::int64_t after = 0) {
    v1::StreamResultsRequest request;
    request.set_id(id);
    request.set_after_sequence(after);
    reader = stub.StreamResults(&context, request);
  }

  /// Reads to the end; the messages, serialized.
  grpc::Status ReadAll() {
    v1::StreamResultsResponse response;
    while (reader->Read(&response)) messages.push_back(response);
    return reader->Finish();
  }
  std::vector<std::string> Bytes() const {
    std::vector<std::string> bytes;
    for (const auto& message : messages) bytes.push_back(message.SerializeAsString());
    return bytes;
  }

  grpc::ClientContext context;
  std::unique_ptr<grpc::ClientReader<v1::StreamResultsResponse>> reader;
  std::vector<v1::StreamResultsResponse> messages;
};

/// Watches to the end; every state of the job that was told.
inline std::vector<v1::Job> WatchToTheEnd(Stub& stub, const std::string& id) {
  grpc::ClientContext context;
  v1::WatchJobRequest request;
  request.set_id(id);
  const auto reader = stub.WatchJob(&context, request);
  std::vector<v1::Job> jobs;
  v1::Job job;
  while (reader->Read(&job)) jobs.push_back(job);
  const grpc::Status status = reader->Finish();
  EXPECT_TRUE(status.ok()) << status.error_message();
  return jobs;
}

}  // namespace celt::host
