#pragma once

#include <cstdint>

#include "celt/v1/job.pb.h"
#include "client/cli/analysis.h"
#include "client/cli/exit_code.h"
#include "client/cli/session.h"

namespace celt::cli {

struct FollowOptions {
  std::int64_t after = 0;       ///< records up to this one are left out
  bool cancel_on_exit = false;  ///< the job is ours: Ctrl-C, or output that nobody takes, ends it
};

/// Prints the records of a job as they come, then its result; shows the progress meanwhile.
ExitCode Follow(const Session& session, const Analysis& analysis, const v1::Job& job,
                const FollowOptions& options);

}  // namespace celt::cli
