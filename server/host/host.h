#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "grpcpp/channel.h"
#include "grpcpp/server.h"
#include "server/api/celt_service.h"
#include "server/auth/gate.h"
#include "server/host/certificates.h"
#include "server/host/keeper.h"
#include "server/jobs/data_dir.h"
#include "server/jobs/scheduler.h"
#include "server/jobs/sqlite_store.h"
#include "server/metrics/http.h"
#include "server/metrics/metrics.h"

namespace celt::host {

/// Files of keys; all may be empty.
struct Keys {
  std::string tokens;       ///< see auth::TokenFile; empty: nobody needs one
  std::string certificate;  ///< with `key`: TLS
  std::string key;
  std::string client_ca;  ///< who signs the certificates of clients; empty: nobody needs one
};

struct HostOptions {
  std::string
      data_dir;  ///< made if there is none, held by this host alone; empty: jobs live in memory
  jobs::Synchronous synchronous = jobs::Synchronous::kNormal;
  int workers = 0;         ///< threads that compute; 0: as many as there are cores
  bool on_demand = false;  ///< jobs of an earlier run sleep until they are asked for
  plans::SpecLimits spec_limits;
  jobs::JobLimits job_limits;
  jobs::Retention retention;
  Keys keys;
  std::string listen;  ///< "host:port", port 0 for a free one; empty: in-process channels only
  std::string http;    ///< the same, for metrics and probes
  /// Told of trouble that no client is told of; `job` may be empty.
  std::function<void(std::string_view job, const absl::Status& error)> on_error =
      [](std::string_view, const absl::Status&) {};
  api::OnCall on_call = [](const api::CallDone&) {};
  std::function<void(std::string_view job, jobs::JobState state, const absl::Status& error)>
      on_end = [](std::string_view, jobs::JobState, const absl::Status&) {};
};

/// The whole service in this process: store, scheduler, gRPC server with health and reflection,
/// metrics and probes over HTTP. Safe to use from many threads.
class Host {
 public:
  /// Goes on with the unfinished jobs of the data directory. UNAVAILABLE: another process
  /// has the directory. FAILED_PRECONDITION: it can't be written, a file in it is not ours, or
  /// nothing can listen at the address. INVALID_ARGUMENT: a file of keys is wrong. Other statuses
  /// are those of SqliteStore::Open.
  static absl::StatusOr<std::unique_ptr<Host>> Start(HostOptions options);
  /// Drains at once, without patience.
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Where it listens, with the port that it got; empty when it doesn't.
  const std::string& address() const { return address_; }
  std::string http_address() const { return http_ == nullptr ? "" : http_->address(); }
  std::shared_ptr<grpc::Channel> InProcessChannel();

  /// Goes down in order: tells health checks, takes no more jobs, stops computing with everything
  /// committed kept, ends streams with UNAVAILABLE, and gives calls that are under way until
  /// `patience` is over. Idempotent.
  void Drain(absl::Duration patience);

 private:
  explicit Host(HostOptions options) : options_(std::move(options)) {}
  absl::Status OpenStore();
  absl::Status OpenGate();
  absl::Status OpenCertificates();
  auth::WatchOptions Watching() const;
  std::shared_ptr<grpc::ServerCredentials> Credentials();
  jobs::SchedulerOptions Scheduling();
  api::ServiceOptions Serving();
  absl::Status StartServer();
  absl::Status StartHttp();
  metrics::Snapshot Count() const;

  const HostOptions options_;
  // In the order of construction: each uses those before it.
  metrics::Metrics metrics_;
  std::unique_ptr<auth::Gate> gate_;
  std::unique_ptr<CertificateFiles> certificates_;
  std::optional<jobs::DataDir> data_dir_;
  std::unique_ptr<jobs::SqliteStore> store_;
  std::unique_ptr<jobs::Scheduler> scheduler_;
  std::unique_ptr<api::CeltService> service_;
  std::unique_ptr<Keeper> keeper_;
  std::unique_ptr<grpc::Server> server_;
  std::unique_ptr<metrics::HttpServer> http_;
  std::string address_;
  std::once_flag drained_;
};

}  // namespace celt::host
