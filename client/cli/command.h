#pragma once

#include <memory>

#include "CLI/App.hpp"
#include "client/cli/analysis.h"
#include "client/cli/exit_code.h"
#include "client/cli/session.h"

namespace celt::cli {

/// A leaf of the command line.
class Command {
 public:
  virtual ~Command() = default;

  /// Adds the command under `parent` and returns it; this object must outlive the parsing.
  virtual CLI::App* AddTo(CLI::App& parent) = 0;
  /// Looks at what was parsed before any service is opened; INVALID_ARGUMENT names the option.
  virtual absl::Status Check(bool /*embedded*/) { return absl::OkStatus(); }
  /// Whether it is about jobs of earlier runs, so that a service that forgets is of no use to it.
  virtual bool NeedsPastJobs() const { return true; }
  virtual ExitCode Run(const Session& session) = 0;
};

using Commands = std::vector<std::unique_ptr<Command>>;

/// `celt <analysis>`; `analysis` must outlive the command.
std::unique_ptr<Command> MakeCompute(Analysis& analysis);

// `celt jobs ...`; `analyses` must outlive the command.
std::unique_ptr<Command> MakeJobsList();
std::unique_ptr<Command> MakeJobsGet();
std::unique_ptr<Command> MakeJobsWatch();
std::unique_ptr<Command> MakeJobsResults(const Analyses& analyses);
std::unique_ptr<Command> MakeJobsCancel();
std::unique_ptr<Command> MakeJobsDelete();

/// `celt server info`.
std::unique_ptr<Command> MakeServerInfo();

}  // namespace celt::cli
