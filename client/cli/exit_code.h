#pragma once

#include "absl/status/status.h"

namespace celt::cli {

/// What scripts may rely on.
enum ExitCode : int {
  kDone = 0,
  kNoAnswer = 1,      ///< the computation ended without its answer
  kBadRequest = 2,    ///< the command line or the specification is wrong
  kNoServer = 3,      ///< the server can't be reached, or refused
  kInterrupted = 130  ///< by Ctrl-C
};

/// The code for a call that ended with `status`.
ExitCode ExitCodeOf(const absl::Status& status);

}  // namespace celt::cli
