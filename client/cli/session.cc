#include "client/cli/session.h"

#include <utility>

#include "absl/strings/str_cat.h"
#include "client/cli/keys.h"
#include "client/cli/parse.h"

namespace celt::cli {
namespace {

absl::StatusOr<client::ClientOptions> MakeClientOptions(const ServiceOptions& options) {
  client::ClientOptions made;
  if (!options.reconnect) return made;
  if (*options.reconnect < 0) {
    return absl::InvalidArgumentError(
        absl::StrCat("--reconnect: '", *options.reconnect, "' is no number of seconds, 0 or more"));
  }
  made.reconnect = absl::Seconds(*options.reconnect);
  return made;
}

absl::Status InUse(const absl::Status& status) {
  return absl::FailedPreconditionError(
      absl::StrCat(status.message(),
                   "; wait for it to end, give --data-dir another directory, or, if it is a celtd, "
                   "speak to it with --server HOST:PORT"));
}

struct StartedService {
  std::unique_ptr<EmbeddedService> service;
  bool keeps_jobs = true;
};

absl::StatusOr<StartedService> StartService(const ServiceOptions& options,
                                            const Environment& environment, Terminal& terminal,
                                            bool needs_past_jobs) {
  EmbeddedOptions embedded;
  embedded.data_dir = options.data_dir.value_or(environment.state_dir);
  if (options.threads) embedded.threads = static_cast<int>(*options.threads);
  auto service = environment.start_embedded(embedded);
  const bool can_forget = !options.data_dir && !needs_past_jobs;
  if (service.ok()) return StartedService{*std::move(service)};
  if (!absl::IsUnavailable(service.status())) return service.status();
  if (!can_forget) return InUse(service.status());
  terminal.Say(absl::StrCat(service.status().message(), "; this job is kept in memory only"));
  embedded.data_dir.clear();
  service = environment.start_embedded(embedded);
  if (!service.ok()) return service.status();
  return StartedService{*std::move(service), false};
}

/// What was given for a service that is not the one used is said, not silently dropped.
void SayIgnored(const ServiceOptions& options, Terminal& terminal) {
  if (options.threads) terminal.Say("--threads: ignored, the server has its own");
  if (options.data_dir) terminal.Say("--data-dir: ignored, the server has its own");
}

}  // namespace

Session::Session(OutputFormat format, Terminal& terminal, std::stop_token interrupt)
    : format_(format), terminal_(terminal), interrupt_(std::move(interrupt)) {}

absl::StatusOr<std::unique_ptr<Session>> Session::Open(const ServiceOptions& options,
                                                       const Environment& environment,
                                                       Terminal& terminal, bool needs_past_jobs) {
  auto client_options = MakeClientOptions(options);
  if (!client_options.ok()) return client_options.status();

  std::unique_ptr<Session> session(
      new Session(options.Format(environment), terminal, environment.interrupt));
  session->server_ = options.Server(environment);
  std::shared_ptr<grpc::Channel> channel;
  if (session->server_.empty()) {
    auto embedded = StartService(options, environment, terminal, needs_past_jobs);
    if (!embedded.ok()) return embedded.status();
    session->embedded_ = std::move(embedded->service);
    session->resumes_ = embedded->keeps_jobs;
    channel = session->embedded_->channel();
  } else {
    const auto address = ParseAddress(session->server_);
    if (!address.ok()) {
      return absl::InvalidArgumentError(absl::StrCat("CELT_SERVER: ", address.status().message()));
    }
    SayIgnored(options, terminal);
    const auto security = SecurityOf(options, environment);
    if (!security.ok()) return security.status();
    const auto token = TokenFor(*address, *security, options, environment);
    if (!token.ok()) return token.status();
    client_options->token = *token;
    channel = client::OpenChannel(*address, *security);
  }
  session->client_ = std::make_unique<client::Client>(std::move(channel), *client_options);
  return session;
}

ExitCode Session::Fail(const absl::Status& status) const {
  if (interrupt_.stop_requested()) {
    terminal_.Say("interrupted");
    return kInterrupted;
  }
  std::string message(status.message());
  if (message.empty()) message = absl::StatusCodeToString(status.code());
  const ExitCode code = ExitCodeOf(status);
  if (code == kNoServer && !server_.empty()) {
    const char* const why = absl::IsUnavailable(status) ? "unavailable: " : "";
    message = absl::StrCat("server ", server_, ": ", why, message);
  }
  terminal_.Say(message);
  return code;
}

ExitCode Session::Written(const absl::Status& status) const {
  if (status.ok()) return kDone;
  if (!terminal_.reader_left()) terminal_.Say(std::string(status.message()));
  return kNoAnswer;
}

}  // namespace celt::cli
