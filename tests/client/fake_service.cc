#include "tests/client/fake_service.h"

#include <algorithm>
#include <chrono>

namespace celt {
namespace {

constexpr char kId[] = "job-1";

grpc::Status Find(const std::string& id) {
  if (id == kId) return grpc::Status::OK;
  return {grpc::StatusCode::NOT_FOUND, "id: no job '" + id + "'"};
}

}  // namespace

FakeService::FakeService() {
  job.set_id(kId);
  job.set_state(v1::Job::STATE_RUNNING);
  job.mutable_spec()->mutable_lyapunov();
  job.mutable_spec()->mutable_system()->set_name("celtic-stone");
  (*job.mutable_spec()->mutable_system()->mutable_parameters())["energy"] = 752;
  int port = 0;
  server_ = grpc::ServerBuilder()
                .AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port)
                .RegisterService(this)
                .BuildAndStart();
  address_ = "127.0.0.1:" + std::to_string(port);
}

FakeService::~FakeService() { server_->Shutdown(std::chrono::system_clock::now()); }

std::shared_ptr<grpc::Channel> FakeService::InProcessChannel() {
  return server_->InProcessChannel({});
}

v1::JobSpec FakeService::submitted() const {
  const std::lock_guard lock(mutex_);
  return submitted_;
}

bool FakeService::fresh() const {
  const std::lock_guard lock(mutex_);
  return fresh_;
}

bool FakeService::validate_only() const {
  const std::lock_guard lock(mutex_);
  return validate_only_;
}

std::string FakeService::authorization() const {
  const std::lock_guard lock(mutex_);
  return authorization_;
}

bool FakeService::cancelled() const {
  const std::lock_guard lock(mutex_);
  return cancelled_;
}

std::vector<std::int64_t> FakeService::resumed_after() const {
  const std::lock_guard lock(mutex_);
  return resumed_after_;
}

grpc::Status FakeService::SubmitJob(grpc::ServerContext* context,
                                    const v1::SubmitJobRequest* request, v1::Job* response) {
  const std::lock_guard lock(mutex_);
  submitted_ = request->spec();
  fresh_ = request->fresh();
  validate_only_ = request->validate_only();
  const auto shown = context->client_metadata().find("authorization");
  const bool is_shown = shown != context->client_metadata().end();
  authorization_ = is_shown ? std::string(shown->second.data(), shown->second.size()) : "";
  *response = job;
  return submit_status;
}

grpc::Status FakeService::GetJob(grpc::ServerContext* /*context*/, const v1::GetJobRequest* request,
                                 v1::Job* response) {
  *response = job;
  return Find(request->id());
}

/// One job a page, two pages.
grpc::Status FakeService::ListJobs(grpc::ServerContext* /*context*/,
                                   const v1::ListJobsRequest* request,
                                   v1::ListJobsResponse* response) {
  *response->add_jobs() = job;
  if (request->page_token().empty()) response->set_next_page_token("second");
  return grpc::Status::OK;
}

grpc::Status FakeService::CancelJob(grpc::ServerContext* /*context*/,
                                    const v1::CancelJobRequest* request, v1::Job* response) {
  if (!cancel_status.ok()) return cancel_status;
  const std::lock_guard lock(mutex_);
  cancelled_ = true;
  changed_.notify_all();
  *response = job;
  response->set_state(v1::Job::STATE_CANCELLED);
  return Find(request->id());
}

grpc::Status FakeService::DeleteJob(grpc::ServerContext* /*context*/,
                                    const v1::DeleteJobRequest* request,
                                    v1::DeleteJobResponse* /*response*/) {
  return Find(request->id());
}

grpc::Status FakeService::WatchJob(grpc::ServerContext* /*context*/,
                                   const v1::WatchJobRequest* request,
                                   grpc::ServerWriter<v1::Job>* writer) {
  for (const v1::Job& update : watched) writer->Write(update);
  return Find(request->id());
}

grpc::Status FakeService::StreamResults(grpc::ServerContext* context,
                                        const v1::StreamResultsRequest* request,
                                        grpc::ServerWriter<v1::StreamResultsResponse>* writer) {
  Script script;
  {
    const std::lock_guard lock(mutex_);
    script = scripts.at(std::min(resumed_after_.size(), scripts.size() - 1));
    resumed_after_.push_back(request->after_sequence());
  }
  for (const auto& message : script.messages) writer->Write(message);
  if (!script.until_cancelled) return script.end;
  on_waiting();
  std::unique_lock lock(mutex_);
  // A synchronous handler can only ask whether its client is gone.
  const auto look_again = std::chrono::milliseconds(10);
  while (!cancelled_ && !context->IsCancelled()) changed_.wait_for(lock, look_again);
  return script.end;
}

grpc::Status FakeService::GetInfo(grpc::ServerContext* /*context*/,
                                  const v1::GetInfoRequest* /*request*/,
                                  v1::GetInfoResponse* response) {
  response->set_version("9.9.9");
  response->set_workers(2);
  response->set_engine_version(7);
  for (const char* analysis : {"lyapunov", "sweep"}) response->add_analyses(analysis);
  for (const auto engine : {v1::ENGINE_ARKODE, v1::ENGINE_FAST}) response->add_engines(engine);
  response->mutable_limits()->set_nodes(10'000);
  response->mutable_limits()->set_computing_seconds(7200);
  v1::SystemInfo& system = *response->add_systems();
  system.set_name("henon3d");
  system.set_description("Three-dimensional Hénon map");
  system.add_coordinates("x");
  v1::ParameterInfo& parameter = *system.add_parameters();
  parameter.set_name("b");
  parameter.set_default_value(0.7);
  parameter.set_range("(-inf, inf)");
  parameter.set_description("Jacobian, in words: constant");
  return grpc::Status::OK;
}

v1::StreamResultsResponse RecordMessage(std::int64_t sequence) {
  v1::StreamResultsResponse message;
  message.mutable_record()->set_sequence(sequence);
  v1::LyapunovRecord& row = *message.mutable_record()->mutable_lyapunov();
  row.set_iterates(100 * sequence);
  for (const double exponent : {0.25, 0.0, -0.5}) {
    row.add_exponents_per_iterate(exponent);
    row.add_exponents_per_time(2 * exponent);
  }
  row.set_mean_return_time(0.5);
  return message;
}

v1::StreamResultsResponse ResultMessage() {
  v1::StreamResultsResponse message;
  v1::LyapunovResult& result = *message.mutable_result()->mutable_lyapunov();
  for (const double exponent : {0.25, 0.0, -0.5}) {
    result.add_exponents_per_iterate(exponent);
    result.add_exponents_per_time(2 * exponent);
    result.add_standard_error_per_iterate(0.0125);
    result.add_standard_error_per_time(0.025);
  }
  result.set_mean_return_time(0.5);
  result.set_standard_error_return_time(0.001);
  result.set_sum_per_iterate(-0.25);
  result.set_standard_error_sum_per_iterate(0.00021);
  result.set_iterates(20000);
  result.set_orbits(8);
  result.set_kaplan_yorke_dimension(2.5);
  v1::Condition& holds = *result.add_conditions();
  holds.set_name("lambda1 > 0");
  holds.set_holds(true);
  holds.set_slack(0.25);
  holds.set_margin(20);
  v1::Condition& fails = *result.add_conditions();
  fails.set_name("lambda1 + lambda2 > 0");
  fails.set_holds(false);
  fails.set_slack(-0.1);
  return message;
}

}  // namespace celt
