// celt: the command line. Only wires: signals, the terminal, the environment, and the service that
// runs in this process when no server is named.

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/cli/environment.h"
#include "client/cli/exit_code.h"
#include "client/cli/run.h"
#include "client/cli/signals.h"
#include "grpc/support/log.h"
#include "server/host/host.h"

namespace {

class HostedService : public celt::cli::EmbeddedService {
 public:
  explicit HostedService(std::unique_ptr<celt::host::Host> host) : host_(std::move(host)) {}
  std::shared_ptr<grpc::Channel> channel() override { return host_->InProcessChannel(); }

 private:
  std::unique_ptr<celt::host::Host> host_;
};

absl::StatusOr<std::unique_ptr<celt::cli::EmbeddedService>> StartHost(
    const celt::cli::EmbeddedOptions& options) {
  celt::host::HostOptions host_options;
  host_options.data_dir = options.data_dir;
  host_options.on_demand = true;
  host_options.workers = options.threads.value_or(0);
  auto host = celt::host::Host::Start(std::move(host_options));
  if (!host.ok()) return host.status();
  return std::make_unique<HostedService>(*std::move(host));
}

std::string Variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Columns of the terminal on standard error; 0 when it is none, or one that can't erase a line.
int ProgressWidth() {
  constexpr int kUsualWidth = 80;
  if (isatty(STDERR_FILENO) != 1 || Variable("TERM") == "dumb") return 0;
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : kUsualWidth;
}

/// gRPC's own chatter is for those who ask for it.
void QuietGrpc() {
  if (Variable("GRPC_VERBOSITY").empty()) gpr_set_log_function([](gpr_log_func_args*) {});
}

int Main(const std::vector<std::string>& arguments) {
  const celt::cli::Signals signals;  // before any other thread
  QuietGrpc();
  celt::cli::Environment environment;
  environment.out = &std::cout;
  environment.err = &std::cerr;
  environment.out_is_terminal = isatty(STDOUT_FILENO) == 1;
  environment.progress_width = ProgressWidth();
  environment.server = Variable("CELT_SERVER");
  environment.token = Variable("CELT_TOKEN");
  environment.token_file = Variable("CELT_TOKEN_FILE");
  environment.tls_ca = Variable("CELT_TLS_CA");
  environment.state_dir = celt::cli::DefaultStateDir();
  environment.start_embedded = StartHost;
  environment.interrupt = signals.interrupt();
  return celt::cli::Run(arguments, environment);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Main(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& error) {
    std::cerr << "celt: " << error.what() << std::endl;
    return celt::cli::kNoAnswer;
  }
}
