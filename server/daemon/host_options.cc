#include "server/daemon/host_options.h"

#include <cstdint>
#include <string>

#include "absl/time/time.h"
#include "server/log/log.h"

namespace celt::daemon {
namespace {

using config::Config;
using log::Level;

template <class Number>
Number OrNone(Number value, Number none) {
  return value > 0 ? value : none;
}

jobs::Retention RetentionOf(const Config::Retention& config) {
  constexpr double kHoursADay = 24;
  constexpr std::int64_t kMegabyte = 1 << 20;
  jobs::Retention retention;
  if (config.record_days > 0) retention.records = absl::Hours(kHoursADay * config.record_days);
  if (config.job_days > 0) retention.jobs = absl::Hours(kHoursADay * config.job_days);
  if (config.store_megabytes > 0) retention.bytes = kMegabyte * config.store_megabytes;
  return retention;
}

void SetLimits(const Config::Limits& limits, host::HostOptions& options) {
  constexpr std::int64_t kNone = jobs::JobLimits::kNone;
  options.spec_limits.iterates = OrNone(limits.iterates, kNone);
  options.spec_limits.nodes = OrNone(limits.nodes, kNone);
  options.spec_limits.records = OrNone(limits.records, kNone);
  options.job_limits.records = OrNone(limits.records, kNone);
  options.job_limits.unfinished = OrNone(limits.unfinished_jobs, kNone);
  options.job_limits.unfinished_per_owner = OrNone(limits.unfinished_jobs_per_owner, kNone);
  if (limits.computing_hours > 0) {
    options.job_limits.computing_time = absl::Hours(limits.computing_hours);
  }
}

void LogError(std::string_view job, const absl::Status& error) {
  log::Write(Level::kError, "trouble", {{"job", std::string(job)}, {"error", error.ToString()}});
}

void LogCall(const api::CallDone& call) {
  log::Write(call.status.ok() ? Level::kDebug : Level::kInfo, "call",
             {{"method", std::string(call.method)},
              {"request", call.request},
              {"owner", call.owner},
              {"job", call.job},
              {"status", absl::StatusCodeToString(call.status.code())},
              {"error", std::string(call.status.message())},
              {"took", absl::FormatDuration(call.took)}});
}

void LogEnd(std::string_view job, jobs::JobState state, const absl::Status& error) {
  const char* how = "cancelled";
  if (state == jobs::JobState::kSucceeded) how = "succeeded";
  if (state == jobs::JobState::kFailed) how = "failed";
  log::Write(Level::kInfo, "job ended",
             {{"job", std::string(job)}, {"state", how}, {"error", std::string(error.message())}});
}

}  // namespace

host::HostOptions HostOptionsOf(const Config& config) {
  host::HostOptions options;
  options.data_dir = config.data_dir;
  options.synchronous =
      config.store.synchronous == "full" ? jobs::Synchronous::kFull : jobs::Synchronous::kNormal;
  options.workers = static_cast<int>(config.workers);
  options.listen = config.listen;
  options.http = config.http;
  options.keys = {.tokens = config.access.tokens,
                  .certificate = config.access.certificate,
                  .key = config.access.key,
                  .client_ca = config.access.client_ca};
  options.retention = RetentionOf(config.retention);
  SetLimits(config.limits, options);
  options.on_error = LogError;
  options.on_call = LogCall;
  options.on_end = LogEnd;
  return options;
}

}  // namespace celt::daemon
