// celtd: the server. Only wires: reads the command line, sets up the log and the signals, serves.

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "grpc/support/log.h"
#include "server/daemon/command_line.h"
#include "server/daemon/new_token.h"
#include "server/daemon/serve.h"
#include "server/daemon/signals.h"
#include "server/log/log.h"

namespace {

int PrintNewToken(const std::string& owner) {
  const auto text = celt::daemon::NewTokenText(owner);
  if (!text.ok()) {
    std::fprintf(stderr, "celtd: %s\n", std::string(text.status().message()).c_str());
    return celt::daemon::kConfigurationWrong;
  }
  std::fputs(text->c_str(), stdout);
  return EXIT_SUCCESS;
}

/// gRPC's own errors, for those who look closely.
void LogOfGrpc(gpr_log_func_args* args) {
  if (args->severity != GPR_LOG_SEVERITY_ERROR) return;
  celt::log::Write(celt::log::Level::kDebug, "gRPC", {{"message", args->message}});
}

int Run(int argc, char** argv) {
  const celt::daemon::CommandLine line = celt::daemon::ReadCommandLine(argc, argv);
  if (line.exit) return *line.exit;
  if (!line.new_token.empty()) return PrintNewToken(line.new_token);
  if (line.check) return EXIT_SUCCESS;
  celt::log::SetUp(line.config.log.level, line.config.log.format);
  gpr_set_log_function(LogOfGrpc);
  const celt::daemon::TerminationSignals signals;
  std::signal(SIGPIPE, SIG_IGN);
  return celt::daemon::Serve(line.config, signals);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "celtd: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
