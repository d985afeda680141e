#include "client/client.h"

#include <chrono>
#include <cstdint>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "client/reconnect.h"
#include "grpcpp/grpcpp.h"

namespace celt::client {
namespace {

absl::Status FromGrpc(const grpc::Status& status) {
  return {static_cast<absl::StatusCode>(status.error_code()), status.error_message()};
}

/// By hand, not as call credentials, which gRPC takes on encrypted channels only: a loopback
/// address may do without.
void ShowToken(const ClientOptions& options, grpc::ClientContext& context) {
  if (!options.token.empty()) context.AddMetadata("authorization", "Bearer " + options.token);
}

template <typename Request>
Request WithId(std::string_view id) {
  Request request;
  request.set_id(std::string(id));
  return request;
}

/// A call with one answer, ended by a deadline or by a stop.
template <typename Response, typename Request>
absl::StatusOr<Response> Call(v1::Celt::Stub& stub,
                              grpc::Status (v1::Celt::Stub::*method)(grpc::ClientContext*,
                                                                     const Request&, Response*),
                              const Request& request, const ClientOptions& options,
                              absl::Duration deadline, const std::stop_token& stop) {
  grpc::ClientContext context;
  ShowToken(options, context);
  context.set_deadline(std::chrono::system_clock::now() + absl::ToChronoMilliseconds(deadline));
  const std::stop_callback on_stop(stop, [&context] { context.TryCancel(); });
  Response response;
  const grpc::Status status = (stub.*method)(&context, request, &response);
  if (status.error_code() == grpc::StatusCode::DEADLINE_EXCEEDED) {
    return absl::DeadlineExceededError(
        absl::StrCat("no answer within ", absl::FormatDuration(deadline)));
  }
  if (!status.ok()) return FromGrpc(status);
  return response;
}

/// Reads a stream to its end; `on_message` may end it early with a status of its own.
template <typename Message, typename Open, typename OnMessage>
absl::Status ReadAll(const ClientOptions& options, const std::stop_token& stop, Open open,
                     OnMessage on_message) {
  grpc::ClientContext context;
  ShowToken(options, context);
  const std::stop_callback on_stop(stop, [&context] { context.TryCancel(); });
  std::unique_ptr<grpc::ClientReader<Message>> reader = open(&context);
  Message message;
  absl::Status status;
  while (status.ok() && reader->Read(&message)) status = on_message(message);
  if (status.ok()) return FromGrpc(reader->Finish());
  context.TryCancel();
  static_cast<void>(reader->Finish());
  return status;
}

std::shared_ptr<grpc::ChannelCredentials> CredentialsOf(const ChannelSecurity& security) {
  if (!security.tls) return grpc::InsecureChannelCredentials();
  grpc::SslCredentialsOptions options;
  options.pem_root_certs = security.authorities;
  options.pem_cert_chain = security.certificate;
  options.pem_private_key = security.key;
  return grpc::SslCredentials(options);
}

bool HasEnded(const v1::Job& job) {
  return job.state() == v1::Job::STATE_SUCCEEDED || job.state() == v1::Job::STATE_FAILED ||
         job.state() == v1::Job::STATE_CANCELLED;
}

}  // namespace

std::shared_ptr<grpc::Channel> OpenChannel(const std::string& address,
                                           const ChannelSecurity& security) {
  constexpr int kSecond = 1000;
  grpc::ChannelArguments arguments;
  arguments.SetInt(GRPC_ARG_ENABLE_HTTP_PROXY, 0);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIME_MS, 60 * kSecond);
  arguments.SetInt(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, 20 * kSecond);
  arguments.SetInt(GRPC_ARG_INITIAL_RECONNECT_BACKOFF_MS, kSecond / 5);
  arguments.SetInt(GRPC_ARG_MIN_RECONNECT_BACKOFF_MS, kSecond / 5);
  arguments.SetInt(GRPC_ARG_MAX_RECONNECT_BACKOFF_MS, 2 * kSecond);
  // Its own connection: a second client of the process must not inherit the first one's backoff.
  arguments.SetInt(GRPC_ARG_USE_LOCAL_SUBCHANNEL_POOL, 1);
  return grpc::CreateCustomChannel(address, CredentialsOf(security), arguments);
}

Client::Client(std::shared_ptr<grpc::Channel> channel, const ClientOptions& options)
    : stub_(v1::Celt::NewStub(std::move(channel))), options_(options) {}

absl::StatusOr<v1::Job> Client::Submit(const v1::SubmitJobRequest& request) const {
  return Call(*stub_, &v1::Celt::Stub::SubmitJob, request, options_, options_.call_deadline, {});
}

absl::StatusOr<v1::Job> Client::Get(std::string_view id, const std::stop_token& stop) const {
  return Call(*stub_, &v1::Celt::Stub::GetJob, WithId<v1::GetJobRequest>(id), options_,
              options_.call_deadline, stop);
}

absl::StatusOr<v1::ListJobsResponse> Client::List(const v1::ListJobsRequest& request,
                                                  const std::stop_token& stop) const {
  return Call(*stub_, &v1::Celt::Stub::ListJobs, request, options_, options_.call_deadline, stop);
}

absl::StatusOr<v1::Job> Client::Cancel(std::string_view id, absl::Duration deadline,
                                       const std::stop_token& stop) const {
  return Call(*stub_, &v1::Celt::Stub::CancelJob, WithId<v1::CancelJobRequest>(id), options_,
              deadline, stop);
}

absl::Status Client::Delete(std::string_view id, const std::stop_token& stop) const {
  return Call(*stub_, &v1::Celt::Stub::DeleteJob, WithId<v1::DeleteJobRequest>(id), options_,
              options_.call_deadline, stop)
      .status();
}

absl::StatusOr<v1::GetInfoResponse> Client::Info(const std::stop_token& stop) const {
  return Call(*stub_, &v1::Celt::Stub::GetInfo, v1::GetInfoRequest(), options_,
              options_.call_deadline, stop);
}

absl::StatusOr<v1::Job> Client::Watch(std::string_view id, OnJob on_job,
                                      const std::stop_token& stop) const {
  const auto request = WithId<v1::WatchJobRequest>(id);
  v1::Job last;
  const absl::Status status = Reconnect(options_.reconnect, stop, [&](bool& progressed) {
    const auto open = [&](grpc::ClientContext* context) {
      return stub_->WatchJob(context, request);
    };
    return ReadAll<v1::Job>(options_, stop, open, [&](const v1::Job& job) {
      progressed = true;
      last = job;
      return on_job(job);
    });
  });
  if (!status.ok()) return status;
  if (!HasEnded(last)) return absl::DataLossError("the server ended the watch before the job");
  return last;
}

absl::StatusOr<v1::Result> Client::Stream(std::string_view id, std::int64_t after,
                                          OnRecord on_record, const std::stop_token& stop) const {
  auto request = WithId<v1::StreamResultsRequest>(id);
  request.set_after_sequence(after);
  std::optional<v1::Result> result;
  const auto on_message = [&](const v1::StreamResultsResponse& message) {
    if (message.has_result()) result = message.result();
    if (!message.has_record()) return absl::OkStatus();
    const v1::Record& record = message.record();
    const std::int64_t expected = request.after_sequence() + 1;
    if (record.sequence() != expected) {
      return absl::DataLossError(absl::StrCat("the server sent record ", record.sequence(),
                                              " where record ", expected, " was due"));
    }
    request.set_after_sequence(record.sequence());
    return on_record(record);
  };
  const absl::Status status = Reconnect(options_.reconnect, stop, [&](bool& progressed) {
    const auto open = [&](grpc::ClientContext* context) {
      return stub_->StreamResults(context, request);
    };
    return ReadAll<v1::StreamResultsResponse>(options_, stop, open,
                                              [&](const v1::StreamResultsResponse& message) {
                                                progressed = true;
                                                return on_message(message);
                                              });
  });
  if (!status.ok()) return status;
  if (!result) return absl::DataLossError("the server ended the stream without the result");
  return *std::move(result);
}

}  // namespace celt::client
