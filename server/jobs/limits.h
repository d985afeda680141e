#pragma once

#include <cstdint>
#include <limits>

#include "absl/time/time.h"

namespace celt::jobs {

/// What jobs may take of a server. By default, all of it.
struct JobLimits {
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::max();
  std::int64_t unfinished = kNone;            ///< jobs that have not ended, of all owners
  std::int64_t unfinished_per_owner = kNone;  ///< and of one
  std::int64_t records = kNone;               ///< of a job; one that has more fails
  /// That a job's units compute, one after the other; one that takes longer fails.
  absl::Duration computing_time = absl::InfiniteDuration();
};

}  // namespace celt::jobs
