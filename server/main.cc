// celtd: the server. Only wires: reads the command line, starts a Host, waits for a signal, drains.

#include <pthread.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "absl/time/time.h"
#include "grpc/support/log.h"
#include "server/host/host.h"
#include "spdlog/sinks/stdout_color_sinks.h"
#include "spdlog/spdlog.h"

namespace {

constexpr int kStartFailed = 1;
constexpr int kCommandLineWrong = 2;
constexpr int kMostWorkers = 1024;

struct Settings {
  std::string listen = "127.0.0.1:7350";
  std::string data_dir;
  int workers = 0;
  double drain_seconds = 10;
};

/// By the XDG rules. Not the folder of the command line's own service, which may run beside this
/// one.
std::string DefaultDataDir() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && *state == '/') return std::string(state) + "/celtd";
  const char* home = std::getenv("HOME");
  return home == nullptr ? std::string() : std::string(home) + "/.local/state/celtd";
}

std::string CheckAddress(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const bool has_port = colon != std::string::npos && colon > 0 && colon + 1 < text.size() &&
                        text.find_first_not_of("0123456789", colon + 1) == std::string::npos &&
                        text.size() - colon <= 6;
  return has_port ? "" : text + " is not HOST:PORT";
}

void Declare(CLI::App& app, Settings& settings) {
  app.set_version_flag("--version", "celtd " CELT_VERSION);
  app.add_option("--listen", settings.listen, "HOST:PORT for gRPC; port 0 takes a free one")
      ->check(CheckAddress)
      ->capture_default_str();
  app.add_option("--data-dir", settings.data_dir, "Where jobs are kept")
      ->default_str(settings.data_dir);
  app.add_option("--workers", settings.workers, "Threads that compute; 0: one a core")
      ->check(CLI::Range(0, kMostWorkers))
      ->capture_default_str();
  app.add_option("--drain-seconds", settings.drain_seconds,
                 "How long calls may go on after the first SIGTERM or SIGINT")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

/// Data goes to stdout, so that everything else goes to stderr.
void SetUpLog() {
  spdlog::set_default_logger(spdlog::stderr_color_mt("celtd"));
  gpr_set_log_function([](gpr_log_func_args* args) {
    if (args->severity == GPR_LOG_SEVERITY_ERROR) spdlog::debug("gRPC: {}", args->message);
  });
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

int Serve(const Settings& settings, const sigset_t& signals) {
  celt::host::HostOptions options;
  options.data_dir = settings.data_dir;
  options.workers = settings.workers;
  options.listen = settings.listen;
  options.on_error = [](std::string_view job, const absl::Status& error) {
    spdlog::error("job {}: {}", job, error.ToString());
  };
  const auto host = celt::host::Host::Start(options);
  if (!host.ok()) {
    spdlog::critical("{}", std::string(host.status().message()));
    return kStartFailed;
  }
  spdlog::info("celtd {} listens on {}, data in {}", CELT_VERSION, (*host)->address(),
               settings.data_dir);
  std::printf("listening on %s\n", (*host)->address().c_str());
  std::fflush(stdout);
  spdlog::info("signal {}: draining", AwaitSignal(signals));
  (*host)->Drain(absl::Seconds(settings.drain_seconds));
  spdlog::info("drained");
  return EXIT_SUCCESS;
}

int Run(int argc, char** argv) {
  CLI::App app("celtd: computes the dynamics of the Celtic stone and of other systems, over gRPC");
  Settings settings;
  settings.data_dir = DefaultDataDir();
  Declare(app, settings);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? EXIT_SUCCESS : kCommandLineWrong;
  }
  SetUpLog();
  if (settings.data_dir.empty()) {
    spdlog::critical("data-dir: missing, and neither XDG_STATE_HOME nor HOME is set");
    return kCommandLineWrong;
  }
  // Before any thread is made, so that all inherit it and signals wait for sigwait.
  const sigset_t signals = TerminationSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
  return Serve(settings, signals);
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
