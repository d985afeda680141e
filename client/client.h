#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <string_view>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "celt/v1/celt.grpc.pb.h"

namespace celt::client {

/// How patient a client is.
struct ClientOptions {
  /// A call with a single answer is given up after this long (DEADLINE_EXCEEDED).
  absl::Duration call_deadline = absl::Seconds(10);
  /// A stream that breaks off is taken up again where it broke, until for this long nothing has
  /// come of it. Zero: never.
  absl::Duration reconnect = absl::Seconds(30);
  /// Shown with every call, where the server wants one.
  std::string token = {};
};

/// How a channel is encrypted; files as PEM, their contents.
struct ChannelSecurity {
  bool tls = false;
  std::string authorities;  ///< that may have signed the server's certificate; empty: the system's
  std::string certificate;  ///< of this client, with `key`; empty: none
  std::string key;
};

/// A channel to `address`, "host:port". Proxies of the environment are ignored. Nothing is sent
/// before the first call.
std::shared_ptr<grpc::Channel> OpenChannel(const std::string& address,
                                           const ChannelSecurity& security = {});

/// The service celt.v1.Celt as functions. A status has the code and message that the service gave;
/// UNAVAILABLE when it could not be reached. Every call with a `stop` ends soon after a stop is
/// asked for, with CANCELLED. Safe to use from many threads.
class Client {
 public:
  /// Called with each record in order; a status that is not OK ends the call with that status.
  using OnRecord = absl::FunctionRef<absl::Status(const v1::Record&)>;
  /// As OnRecord, with the job whenever it has changed.
  using OnJob = absl::FunctionRef<absl::Status(const v1::Job&)>;

  explicit Client(std::shared_ptr<grpc::Channel> channel, const ClientOptions& options = {});

  absl::StatusOr<v1::Job> Submit(const v1::SubmitJobRequest& request) const;
  absl::StatusOr<v1::Job> Get(std::string_view id, const std::stop_token& stop = {}) const;
  absl::StatusOr<v1::ListJobsResponse> List(const v1::ListJobsRequest& request,
                                            const std::stop_token& stop = {}) const;
  /// `deadline` replaces the option's.
  absl::StatusOr<v1::Job> Cancel(std::string_view id, absl::Duration deadline,
                                 const std::stop_token& stop = {}) const;
  absl::Status Delete(std::string_view id, const std::stop_token& stop = {}) const;
  absl::StatusOr<v1::GetInfoResponse> Info(const std::stop_token& stop = {}) const;

  /// Follows a job to its end and returns it as it ended, whatever the state. Reconnects.
  absl::StatusOr<v1::Job> Watch(std::string_view id, OnJob on_job,
                                const std::stop_token& stop = {}) const;

  /// Reads the records with a sequence number above `after`, then returns the result. Each record
  /// is given once and in order, however often the stream broke off. FAILED_PRECONDITION: the job
  /// failed, ABORTED: it was cancelled. DATA_LOSS: the server left a gap.
  absl::StatusOr<v1::Result> Stream(std::string_view id, std::int64_t after, OnRecord on_record,
                                    const std::stop_token& stop = {}) const;

 private:
  std::unique_ptr<v1::Celt::Stub> stub_;
  ClientOptions options_;
};

}  // namespace celt::client
