// celtd: the server. Only wires: reads the configuration, starts a Host, waits for a signal,
// drains.

#include <pthread.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/time/time.h"
#include "grpc/support/log.h"
#include "server/auth/tokens.h"
#include "server/config/config.h"
#include "server/host/host.h"
#include "server/log/log.h"

namespace {

using celt::config::Config;
using celt::config::Setting;
using celt::log::Level;

constexpr int kStartFailed = 1;
constexpr int kConfigurationWrong = 2;

/// What the command line says.
struct Arguments {
  std::string file;
  std::vector<std::function<absl::Status()>> overrides;  ///< of the file, in order
  bool check = false;
  std::string new_token;  ///< OWNER or OWNER:admin
};

/// By the XDG rules. Not the folder of the command line's own service, which may run beside this
/// one.
std::string DefaultDataDir() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && *state == '/') return std::string(state) + "/celtd";
  const char* home = std::getenv("HOME");
  return home == nullptr ? std::string() : std::string(home) + "/.local/state/celtd";
}

template <class Value>
CLI::Option* AddOverride(CLI::App& app, const Setting& setting, Arguments& arguments) {
  const auto add = [setting, &arguments](const Value& value) {
    arguments.overrides.push_back([setting, value] { return setting.Set(value); });
  };
  return app.add_option_function<Value>(setting.Flag(), add, setting.help);
}

void Declare(CLI::App& app, Config& config, Arguments& arguments) {
  app.set_version_flag("--version", "celtd " CELT_VERSION);
  app.add_option("--config", arguments.file, "TOML file; the other options win over it");
  app.add_flag("--check", arguments.check, "Only check the configuration");
  app.add_option("--new-token", arguments.new_token,
                 "Print a token for OWNER or OWNER:admin and its line in the file of tokens");
  for (const Setting& setting : celt::config::SettingsOf(config)) {
    if (std::holds_alternative<std::string*>(setting.place)) {
      AddOverride<std::string>(app, setting, arguments);
    } else if (std::holds_alternative<std::int64_t*>(setting.place)) {
      AddOverride<std::int64_t>(app, setting, arguments);
    } else {
      AddOverride<double>(app, setting, arguments);
    }
  }
}

absl::Status Configure(const Arguments& arguments, Config& config) {
  if (!arguments.file.empty()) {
    absl::Status status = celt::config::ReadFile(arguments.file, config);
    if (!status.ok()) return status;
  }
  for (const auto& override_setting : arguments.overrides) {
    absl::Status status = override_setting();
    if (!status.ok()) return status;
  }
  return celt::config::Check(config);
}

int PrintNewToken(const std::string& text) {
  const std::size_t colon = text.find(':');
  const bool admin = colon != std::string::npos && text.substr(colon) == ":admin";
  const std::string owner = text.substr(0, colon);
  const bool good = (colon == std::string::npos || admin) && !owner.empty() && owner[0] != '#' &&
                    owner.find_first_of(" \t\n") == std::string::npos;
  if (!good) {
    std::fprintf(stderr, "celtd: --new-token: '%s' is not OWNER or OWNER:admin\n", text.c_str());
    return kConfigurationWrong;
  }
  const std::string token = celt::auth::NewToken();
  std::printf("token, for its owner alone: %s\nline of the file of tokens:  %s\n", token.c_str(),
              celt::auth::TokenLine({owner, admin}, token).c_str());
  return EXIT_SUCCESS;
}

template <class Number>
Number OrNone(Number value, Number none) {
  return value > 0 ? value : none;
}

celt::jobs::Retention RetentionOf(const Config::Retention& config) {
  constexpr double kHoursADay = 24;
  constexpr std::int64_t kMegabyte = 1 << 20;
  celt::jobs::Retention retention;
  if (config.record_days > 0) retention.records = absl::Hours(kHoursADay * config.record_days);
  if (config.job_days > 0) retention.jobs = absl::Hours(kHoursADay * config.job_days);
  if (config.store_megabytes > 0) retention.bytes = kMegabyte * config.store_megabytes;
  return retention;
}

void SetLimits(const Config::Limits& limits, celt::host::HostOptions& options) {
  constexpr std::int64_t kNone = celt::jobs::JobLimits::kNone;
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

void SetLog(celt::host::HostOptions& options) {
  options.on_error = [](std::string_view job, const absl::Status& error) {
    celt::log::Write(Level::kError, "trouble",
                     {{"job", std::string(job)}, {"error", error.ToString()}});
  };
  options.on_call = [](const celt::api::CallDone& call) {
    celt::log::Write(call.status.ok() ? Level::kDebug : Level::kInfo, "call",
                     {{"method", std::string(call.method)},
                      {"request", call.request},
                      {"owner", call.owner},
                      {"job", call.job},
                      {"status", absl::StatusCodeToString(call.status.code())},
                      {"error", std::string(call.status.message())},
                      {"took", absl::FormatDuration(call.took)}});
  };
  options.on_end = [](std::string_view job, celt::jobs::JobState state, const absl::Status& error) {
    const char* how = "cancelled";
    if (state == celt::jobs::JobState::kSucceeded) how = "succeeded";
    if (state == celt::jobs::JobState::kFailed) how = "failed";
    celt::log::Write(
        Level::kInfo, "job ended",
        {{"job", std::string(job)}, {"state", how}, {"error", std::string(error.message())}});
  };
}

celt::host::HostOptions OptionsOf(const Config& config) {
  celt::host::HostOptions options;
  options.data_dir = config.data_dir;
  options.workers = static_cast<int>(config.workers);
  options.listen = config.listen;
  options.http = config.http;
  options.keys = {.tokens = config.access.tokens,
                  .certificate = config.access.certificate,
                  .key = config.access.key,
                  .client_ca = config.access.client_ca};
  options.retention = RetentionOf(config.retention);
  SetLimits(config.limits, options);
  SetLog(options);
  return options;
}

sigset_t TerminationSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

/// Waits for the first signal. The second one then kills, as if nothing were set up.
int AwaitSignal(const sigset_t& signals) {
  int received = 0;
  sigwait(&signals, &received);
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  return received;
}

int Serve(const Config& config, const sigset_t& signals) {
  const auto host = celt::host::Host::Start(OptionsOf(config));
  if (!host.ok()) {
    celt::log::Write(Level::kCritical, "can't start",
                     {{"error", std::string(host.status().message())}});
    return absl::IsInvalidArgument(host.status()) ? kConfigurationWrong : kStartFailed;
  }
  celt::log::Write(Level::kInfo, "listening",
                   {{"version", CELT_VERSION},
                    {"grpc", (*host)->address()},
                    {"http", (*host)->http_address()},
                    {"data", config.data_dir},
                    {"tls", config.access.certificate.empty() ? "no, loopback only" : "yes"}});
  std::printf("listening on %s\n", (*host)->address().c_str());
  if (!config.http.empty()) std::printf("http on %s\n", (*host)->http_address().c_str());
  std::fflush(stdout);
  celt::log::Write(Level::kInfo, "draining", {{"signal", absl::StrCat(AwaitSignal(signals))}});
  (*host)->Drain(absl::Seconds(config.drain_seconds));
  celt::log::Write(Level::kInfo, "drained");
  return EXIT_SUCCESS;
}

int Run(int argc, char** argv) {
  CLI::App app("celtd: computes the dynamics of the Celtic stone and of other systems, over gRPC");
  Config config;
  config.data_dir = DefaultDataDir();
  Arguments arguments;
  Declare(app, config, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? EXIT_SUCCESS : kConfigurationWrong;
  }
  if (!arguments.new_token.empty()) return PrintNewToken(arguments.new_token);
  if (const absl::Status status = Configure(arguments, config); !status.ok()) {
    std::fprintf(stderr, "celtd: %s\n", std::string(status.message()).c_str());
    return kConfigurationWrong;
  }
  if (arguments.check) return EXIT_SUCCESS;
  celt::log::SetUp(config.log.level, config.log.format);
  gpr_set_log_function([](gpr_log_func_args* args) {
    if (args->severity != GPR_LOG_SEVERITY_ERROR) return;
    celt::log::Write(Level::kDebug, "gRPC", {{"message", args->message}});
  });
  // Before any thread is made, so that all inherit it and signals wait for sigwait.
  const sigset_t signals = TerminationSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  return Serve(config, signals);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "celtd: %s\n", error.what());
    return kStartFailed;
  }
}
