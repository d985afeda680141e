#pragma once

#include <cstdint>
#include <string>

#include "absl/status/status.h"
#include "absl/time/time.h"

namespace celt::jobs {

enum class JobState { kQueued = 1, kRunning = 2, kSucceeded = 3, kFailed = 4, kCancelled = 5 };

/// Whether a job in this state will never change again.
constexpr bool HasEnded(JobState state) { return state >= JobState::kSucceeded; }

/// What is known of a job besides its records and checkpoints. The specification and the result are
/// bytes that only plans and handlers can read.
struct Job {
  std::string id;
  std::string owner;                ///< empty where there are no owners
  std::string specification;        ///< resolved: defaults filled in
  std::int64_t engine_version = 0;  ///< answers of one version are the same bytes
  JobState state = JobState::kQueued;
  double work_done = 0;
  double work_total = 0;
  double unit_seconds = 0;         ///< that its units have computed, one after the other
  std::string work_unit;           ///< plural, such as "iterates"
  std::int64_t dropped = 0;        ///< records up to this one are no longer kept
  std::int64_t last_sequence = 0;  ///< of its records; 0 while there is none
  absl::Status error;              ///< not OK exactly when the state is kFailed
  std::string result;              ///< empty unless the state is kSucceeded
  absl::Time created;
  absl::Time started = absl::InfinitePast();  ///< InfinitePast while it has not
  absl::Time ended = absl::InfinitePast();    ///< InfinitePast while it has not
};

/// One record of a job: opaque bytes under a sequence number that counts from 1 without gaps.
struct StoredRecord {
  std::int64_t sequence = 0;
  std::string bytes;
};

}  // namespace celt::jobs
