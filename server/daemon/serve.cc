#include "server/daemon/serve.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include "absl/strings/str_cat.h"
#include "absl/time/time.h"
#include "server/daemon/command_line.h"
#include "server/daemon/host_options.h"
#include "server/host/host.h"
#include "server/log/log.h"

namespace celt::daemon {
namespace {

using log::Level;

void SayListening(const host::Host& host, const config::Config& config) {
  log::Write(Level::kInfo, "listening",
             {{"version", CELT_VERSION},
              {"grpc", host.address()},
              {"http", host.http_address()},
              {"data", config.data_dir},
              {"tls", config.access.certificate.empty() ? "no, loopback only" : "yes"}});
  std::printf("listening on %s\n", host.address().c_str());
  if (!config.http.empty()) std::printf("http on %s\n", host.http_address().c_str());
  std::fflush(stdout);
}

}  // namespace

int Serve(const config::Config& config, const TerminationSignals& signals) {
  const auto host = host::Host::Start(HostOptionsOf(config));
  if (!host.ok()) {
    log::Write(Level::kCritical, "can't start", {{"error", std::string(host.status().message())}});
    return absl::IsInvalidArgument(host.status()) ? kConfigurationWrong : EXIT_FAILURE;
  }
  SayListening(**host, config);
  log::Write(Level::kInfo, "draining", {{"signal", absl::StrCat(signals.Await())}});
  (*host)->Drain(absl::Seconds(config.drain_seconds));
  log::Write(Level::kInfo, "drained");
  return EXIT_SUCCESS;
}

}  // namespace celt::daemon
