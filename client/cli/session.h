#pragma once

#include <memory>
#include <stop_token>
#include <string>

#include "absl/status/statusor.h"
#include "client/cli/environment.h"
#include "client/cli/exit_code.h"
#include "client/cli/service_options.h"
#include "client/cli/terminal.h"
#include "client/client.h"

namespace celt::cli {

/// What a command works with: a service, remote or embedded, and a terminal.
class Session {
 public:
  /// Starts the embedded service, or names the remote one without calling it. INVALID_ARGUMENT
  /// names the option that is wrong; any other status is of an embedded service that can't start.
  /// Two runs side by side can't share the default data directory: unless `needs_past_jobs`, the
  /// second one says so and keeps its job in memory. `terminal` must outlive the session.
  static absl::StatusOr<std::unique_ptr<Session>> Open(const ServiceOptions& options,
                                                       const Environment& environment,
                                                       Terminal& terminal, bool needs_past_jobs);

  const client::Client& client() const { return *client_; }
  Terminal& terminal() const { return terminal_; }
  OutputFormat format() const { return format_; }
  /// Whether jobs live in this process and end with it.
  bool embedded() const { return embedded_ != nullptr; }
  /// Whether the same command goes on where an interrupted one stopped: the service is embedded and
  /// keeps its jobs.
  bool resumes() const { return resumes_; }
  /// A stop is asked for at Ctrl-C.
  const std::stop_token& interrupt() const { return interrupt_; }

  /// Says why a call failed, in one line, and gives the exit code for it.
  ExitCode Fail(const absl::Status& status) const;
  /// The exit code after data was written: says what went wrong, but not that nobody reads any
  /// more.
  ExitCode Written(const absl::Status& status) const;

 private:
  Session(OutputFormat format, Terminal& terminal, std::stop_token interrupt);

  OutputFormat format_;
  Terminal& terminal_;
  std::stop_token interrupt_;
  std::string server_;  ///< empty: embedded
  std::unique_ptr<EmbeddedService> embedded_;
  bool resumes_ = false;
  std::unique_ptr<client::Client> client_;
};

}  // namespace celt::cli
