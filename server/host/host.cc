#include "server/host/host.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "grpcpp/ext/proto_server_reflection_plugin.h"
#include "grpcpp/health_check_service_interface.h"
#include "grpcpp/server_builder.h"
#include "server/host/credentials.h"
#include "server/jobs/status_macros.h"
#include "server/plans/engine_version.h"
#include "server/plans/factory.h"
#include "server/plans/load.h"

namespace celt::host {
namespace {

constexpr const char* kServiceName = "celt.v1.Celt";
/// What a job may compute before it counts as a long one.
constexpr absl::Duration kExpress = absl::Seconds(1);
constexpr absl::Duration kBetweenKeeping = absl::Minutes(1);
constexpr int kLargestRequest = 1 << 20;
// Tighter pings would cut off live clients on slow lines.
constexpr int kKeepaliveMilliseconds = 60'000;
constexpr int kKeepaliveTimeoutMilliseconds = 20'000;

/// gRPC wants these before the first server is built, and once.
void EnableStandardServices() {
  static const bool enabled = [] {
    grpc::EnableDefaultHealthCheckService(true);
    grpc::reflection::InitProtoReflectionServerBuilderPlugin();
    return true;
  }();
  static_cast<void>(enabled);
}

void Configure(grpc::ServerBuilder& builder) {
  // Two servers on one port would share its clients between them.
  builder.AddChannelArgument(GRPC_ARG_ALLOW_REUSEPORT, 0);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIME_MS, kKeepaliveMilliseconds);
  builder.AddChannelArgument(GRPC_ARG_KEEPALIVE_TIMEOUT_MS, kKeepaliveTimeoutMilliseconds);
  builder.SetMaxReceiveMessageSize(kLargestRequest);
}

std::string WithPort(const std::string& listen, int port) {
  return absl::StrCat(listen.substr(0, listen.rfind(':')), ":", port);
}

}  // namespace

absl::StatusOr<std::unique_ptr<Host>> Host::Start(HostOptions options) {
  std::unique_ptr<Host> host(new Host(std::move(options)));
  CELT_RETURN_IF_ERROR(host->OpenGate());
  CELT_RETURN_IF_ERROR(host->OpenCertificates());
  CELT_RETURN_IF_ERROR(host->OpenStore());
  host->scheduler_ =
      std::make_unique<jobs::Scheduler>(*host->store_, plans::MakePlan, host->Scheduling());
  host->service_ = std::make_unique<api::CeltService>(*host->store_, *host->scheduler_,
                                                      *host->gate_, host->Serving());
  CELT_RETURN_IF_ERROR(host->scheduler_->Start());
  CELT_RETURN_IF_ERROR(host->StartServer());
  CELT_RETURN_IF_ERROR(host->StartHttp());
  host->keeper_ = std::make_unique<Keeper>(
      *host->store_, host->options_.retention, kBetweenKeeping,
      [raw = host.get()](const absl::Status& error) { raw->options_.on_error("", error); });
  return host;
}

absl::Status Host::OpenGate() {
  const Keys& keys = options_.keys;
  std::unique_ptr<auth::TokenFile> tokens;
  if (!keys.tokens.empty()) {
    CELT_ASSIGN_OR_RETURN(tokens, auth::TokenFile::Open(keys.tokens, Watching()));
  }
  gate_ = std::make_unique<auth::Gate>(std::move(tokens), !keys.client_ca.empty());
  return absl::OkStatus();
}

auth::WatchOptions Host::Watching() const {
  auth::WatchOptions watching;
  watching.on_error = [this](const absl::Status& error) { options_.on_error("", error); };
  return watching;
}

absl::Status Host::OpenCertificates() {
  if (options_.keys.certificate.empty()) return absl::OkStatus();
  CELT_ASSIGN_OR_RETURN(certificates_, CertificateFiles::Open(options_.keys, Watching()));
  return absl::OkStatus();
}

/// Certificates of clients are asked for where their authorities are named, and required unless
/// tokens do as well.
std::shared_ptr<grpc::ServerCredentials> Host::Credentials() {
  if (certificates_ == nullptr) return grpc::InsecureServerCredentials();
  ClientCertificates clients = ClientCertificates::kNone;
  if (!options_.keys.client_ca.empty()) {
    clients =
        options_.keys.tokens.empty() ? ClientCertificates::kRequired : ClientCertificates::kWelcome;
  }
  return TlsCredentials(*certificates_, clients);
}

absl::Status Host::OpenStore() {
  std::string path = ":memory:";
  if (!options_.data_dir.empty()) {
    CELT_ASSIGN_OR_RETURN(data_dir_, jobs::DataDir::Lock(options_.data_dir));
    path = data_dir_->StorePath();
  }
  CELT_ASSIGN_OR_RETURN(store_, jobs::SqliteStore::Open(path, options_.synchronous));
  return absl::OkStatus();
}

jobs::SchedulerOptions Host::Scheduling() {
  jobs::SchedulerOptions scheduling;
  scheduling.workers = options_.workers;
  // For a service of one question there is nobody who would wait.
  scheduling.express = options_.on_demand ? absl::ZeroDuration() : kExpress;
  scheduling.engine_version = plans::kEngineVersion;
  scheduling.limits = options_.job_limits;
  scheduling.load = plans::LoadOf;
  scheduling.on_demand = options_.on_demand;
  scheduling.on_error = [this](std::string_view job, const absl::Status& error) {
    metrics_.CountStoreError();
    options_.on_error(job, error);
  };
  scheduling.on_unit = [this](const jobs::UnitDone& unit) {
    metrics_.CountUnit(unit.took, unit.work, unit.work_unit);
  };
  scheduling.on_end = options_.on_end;
  return scheduling;
}

api::ServiceOptions Host::Serving() {
  api::ServiceOptions serving;
  serving.limits = options_.spec_limits;
  serving.on_call = [this](const api::CallDone& call) {
    metrics_.CountCall(call.method, call.status.code(), call.took);
    options_.on_call(call);
  };
  return serving;
}

absl::Status Host::StartServer() {
  EnableStandardServices();
  grpc::ServerBuilder builder;
  Configure(builder);
  const std::string& listen = options_.listen;
  int port = 0;
  if (!listen.empty()) builder.AddListeningPort(listen, Credentials(), &port);
  builder.RegisterService(service_.get());
  server_ = builder.BuildAndStart();
  if (server_ == nullptr || (!listen.empty() && port == 0)) {
    return absl::FailedPreconditionError(
        absl::StrCat("listen: can't listen on ", listen,
                     ": the port is in use, or the address is not one of this machine"));
  }
  if (!listen.empty()) address_ = WithPort(listen, port);
  server_->GetHealthCheckService()->SetServingStatus(kServiceName, true);
  return absl::OkStatus();
}

absl::Status Host::StartHttp() {
  if (options_.http.empty()) return absl::OkStatus();
  CELT_ASSIGN_OR_RETURN(
      http_, metrics::HttpServer::Start(options_.http,
                                        {.metrics = [this] { return metrics_.Text(Count()); },
                                         .ready = [this] { return !scheduler_->stopping(); }}));
  return absl::OkStatus();
}

metrics::Snapshot Host::Count() const {
  static constexpr std::pair<jobs::JobState, const char*> kStates[] = {
      {jobs::JobState::kQueued, "queued"},
      {jobs::JobState::kRunning, "running"},
      {jobs::JobState::kSucceeded, "succeeded"},
      {jobs::JobState::kFailed, "failed"},
      {jobs::JobState::kCancelled, "cancelled"}};
  metrics::Snapshot snapshot;
  if (const auto stats = store_->Stats(); stats.ok()) {
    for (const auto& [state, name] : kStates) {
      const auto found = stats->jobs.find(state);
      snapshot.jobs[name] = found == stats->jobs.end() ? 0 : static_cast<double>(found->second);
    }
    snapshot.store_bytes = static_cast<double>(stats->bytes);
    snapshot.store_synchronous = static_cast<double>(stats->synchronous);
  }
  snapshot.active_jobs = static_cast<double>(scheduler_->active_jobs());
  snapshot.paces = scheduler_->forecast().Paces();
  snapshot.streams = static_cast<double>(service_->open_streams());
  return snapshot;
}

Host::~Host() { Drain(absl::ZeroDuration()); }

std::shared_ptr<grpc::Channel> Host::InProcessChannel() {
  return server_->InProcessChannel(grpc::ChannelArguments());
}

void Host::Drain(absl::Duration patience) {
  std::call_once(drained_, [&] {
    if (server_ == nullptr) return;
    server_->GetHealthCheckService()->SetServingStatus(false);
    scheduler_->Shutdown();
    service_->EndStreams();
    server_->Shutdown(absl::ToChronoTime(absl::Now() + patience));
  });
}

}  // namespace celt::host
