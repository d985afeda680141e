#include "server/host/host.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "grpcpp/ext/proto_server_reflection_plugin.h"
#include "grpcpp/health_check_service_interface.h"
#include "grpcpp/security/server_credentials.h"
#include "grpcpp/server_builder.h"
#include "server/jobs/status_macros.h"
#include "server/plans/engine_version.h"
#include "server/plans/factory.h"

namespace celt::host {
namespace {

constexpr const char* kServiceName = "celt.v1.Celt";
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
  std::unique_ptr<Host> host(new Host);
  CELT_RETURN_IF_ERROR(host->OpenStore(options));
  jobs::SchedulerOptions scheduling;
  scheduling.workers = options.workers;
  scheduling.engine_version = plans::kEngineVersion;
  scheduling.limits = options.job_limits;
  scheduling.on_demand = options.on_demand;
  scheduling.on_error = std::move(options.on_error);
  host->scheduler_ =
      std::make_unique<jobs::Scheduler>(*host->store_, plans::MakePlan, std::move(scheduling));
  host->service_ =
      std::make_unique<api::CeltService>(*host->store_, *host->scheduler_, options.spec_limits);
  CELT_RETURN_IF_ERROR(host->scheduler_->Start());
  CELT_RETURN_IF_ERROR(host->StartServer(options.listen));
  return host;
}

absl::Status Host::OpenStore(const HostOptions& options) {
  std::string path = ":memory:";
  if (!options.data_dir.empty()) {
    CELT_ASSIGN_OR_RETURN(data_dir_, jobs::DataDir::Lock(options.data_dir));
    path = data_dir_->StorePath();
  }
  CELT_ASSIGN_OR_RETURN(store_, jobs::SqliteStore::Open(path));
  return absl::OkStatus();
}

absl::Status Host::StartServer(const std::string& listen) {
  EnableStandardServices();
  grpc::ServerBuilder builder;
  Configure(builder);
  int port = 0;
  if (!listen.empty()) {
    builder.AddListeningPort(listen, grpc::InsecureServerCredentials(), &port);
  }
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
