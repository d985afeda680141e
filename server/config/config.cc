#include "server/config/config.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "server/jobs/status_macros.h"

namespace celt::config {
namespace {

constexpr double kMostWorkers = 1024;
constexpr double kCounts = 1e15;
constexpr double kDays = 100'000;

absl::Status NotAllowed(const Setting& setting, const std::string& value, const std::string& what) {
  return absl::InvalidArgumentError(
      absl::StrCat(setting.name, ": ", value, " is not allowed; ", what));
}

absl::Status WrongKind(const Setting& setting) {
  const char* what = "a text is expected";
  if (std::holds_alternative<std::int64_t*>(setting.place)) what = "a whole number is expected";
  if (std::holds_alternative<double*>(setting.place)) what = "a number is expected";
  return absl::InvalidArgumentError(absl::StrCat(setting.name, ": ", what));
}

/// Whether nobody outside this machine can reach the address.
bool IsLoopback(std::string_view address) {
  const std::string_view host = address.substr(0, address.rfind(':'));
  return host == "localhost" || host == "[::1]" || host.starts_with("127.");
}

absl::Status CheckAddress(const std::string& name, const std::string& address) {
  const std::size_t colon = address.rfind(':');
  const bool good = colon != std::string::npos && colon > 0 && colon + 1 < address.size() &&
                    address.find_first_not_of("0123456789", colon + 1) == std::string::npos &&
                    address.size() - colon <= 6;
  if (good) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(name, ": '", address, "' is not HOST:PORT"));
}

absl::Status CheckAccess(const Config& config) {
  const Config::Access& access = config.access;
  if (access.certificate.empty() != access.key.empty()) {
    return absl::InvalidArgumentError(
        "access.key: a certificate and its key go together; set both or none");
  }
  const bool tls = !access.certificate.empty();
  if (!access.client_ca.empty() && !tls) {
    return absl::InvalidArgumentError(
        "access.client_ca: needs access.certificate and access.key: no TLS, no certificates");
  }
  const bool owners = !access.tokens.empty() || !access.client_ca.empty();
  if (IsLoopback(config.listen) || (tls && owners)) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat("listen: ", config.listen,
                   " is not a loopback address; others may only reach a server with TLS "
                   "(access.certificate, access.key) that knows its users (access.tokens or "
                   "access.client_ca)"));
}

}  // namespace

std::string Setting::Flag() const {
  std::string flag = "--" + name;
  std::replace_if(
      flag.begin(), flag.end(), [](char c) { return c == '.' || c == '_'; }, '-');
  return flag;
}

absl::Status Setting::Set(std::string value) const {
  auto* const* const target = std::get_if<std::string*>(&place);
  if (target == nullptr) return WrongKind(*this);
  if (!choices.empty() && std::find(choices.begin(), choices.end(), value) == choices.end()) {
    return NotAllowed(*this, value, absl::StrCat("it is one of ", absl::StrJoin(choices, ", ")));
  }
  **target = std::move(value);
  return absl::OkStatus();
}

absl::Status Setting::Set(std::int64_t value) const {
  auto* const* const target = std::get_if<std::int64_t*>(&place);
  if (target == nullptr) return Set(static_cast<double>(value));
  if (value < 0 || static_cast<double>(value) > highest) {
    return NotAllowed(*this, absl::StrCat(value), absl::StrCat("it lies in [0, ", highest, "]"));
  }
  **target = value;
  return absl::OkStatus();
}

absl::Status Setting::Set(double value) const {
  auto* const* const target = std::get_if<double*>(&place);
  if (target == nullptr) return WrongKind(*this);
  if (!(value >= 0) || value > highest) {
    return NotAllowed(*this, absl::StrCat(value), absl::StrCat("it lies in [0, ", highest, "]"));
  }
  **target = value;
  return absl::OkStatus();
}

std::vector<Setting> SettingsOf(Config& c) {
  Config::Limits& limits = c.limits;
  Config::Retention& retention = c.retention;
  return {
      {"listen", "HOST:PORT for gRPC; port 0 takes a free one", &c.listen},
      {"http", "HOST:PORT for metrics and health over HTTP; empty for none", &c.http},
      {"data_dir", "Where jobs are kept (default: XDG state folder)", &c.data_dir},
      {"workers", "Threads that compute; 0: one a core", &c.workers, kMostWorkers},
      {"drain_seconds", "How long calls may go on after the first SIGTERM or SIGINT",
       &c.drain_seconds, kDays},
      {"limits.iterates", "Iterates of a job, over all orbits and nodes", &limits.iterates,
       kCounts},
      {"limits.nodes", "Nodes of a sweep", &limits.nodes, kCounts},
      {"limits.records", "Records of a job", &limits.records, kCounts},
      {"limits.computing_hours", "Time that a job computes, summed over threads; 0: no limit",
       &limits.computing_hours, kDays},
      {"limits.unfinished_jobs", "Jobs that have not ended, of all owners", &limits.unfinished_jobs,
       kCounts},
      {"limits.unfinished_jobs_per_owner", "Jobs that have not ended, of one owner",
       &limits.unfinished_jobs_per_owner, kCounts},
      {"retention.record_days", "Records of ended jobs are dropped after so many days; 0: never",
       &retention.record_days, kDays},
      {"retention.job_days", "Ended jobs are deleted after so many days; 0: never",
       &retention.job_days, kDays},
      {"retention.store_megabytes",
       "Above this size, records of the jobs that ended first are dropped; 0: never",
       &retention.store_megabytes, kCounts},
      {"store.synchronous",
       "normal: a power cut may take the last seconds of work with it; full: nothing",
       &c.store.synchronous,
       0,
       {"normal", "full"}},
      {"access.tokens", "File of the tokens that give access", &c.access.tokens},
      {"access.certificate", "File of the server's certificate chain (PEM): turns TLS on",
       &c.access.certificate},
      {"access.key", "File of its private key (PEM)", &c.access.key},
      {"access.client_ca", "File of the authorities (PEM) whose client certificates give access",
       &c.access.client_ca},
      {"log.level",
       "trace, debug, info, warning, error or critical",
       &c.log.level,
       0,
       {"trace", "debug", "info", "warning", "error", "critical"}},
      {"log.format", "text, or json: one object a line", &c.log.format, 0, {"text", "json"}},
  };
}

absl::Status Check(const Config& config) {
  CELT_RETURN_IF_ERROR(CheckAddress("listen", config.listen));
  if (!config.http.empty()) CELT_RETURN_IF_ERROR(CheckAddress("http", config.http));
  if (config.data_dir.empty()) {
    return absl::InvalidArgumentError(
        "data_dir: missing, and neither XDG_STATE_HOME nor HOME is set");
  }
  return CheckAccess(config);
}

}  // namespace celt::config
