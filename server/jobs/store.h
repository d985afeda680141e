#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/jobs/job.h"
#include "server/jobs/plan.h"

namespace celt::jobs {

/// A chain's place: its next unit starts from `checkpoint`.
struct ChainPosition {
  std::int64_t chain = 0;
  std::int64_t next_step = 0;
  std::string checkpoint;
  bool ended = false;
};

/// A unit that was run but not yet collected.
struct PendingPayload {
  UnitId unit;
  std::string payload;
};

/// What a unit changed, committed as one: either all of it is in the store, or nothing is.
struct UnitCommit {
  ChainPosition position;  ///< of the chain whose unit was run
  std::vector<PendingPayload>
      added;  ///< payloads now waiting to be collected (the unit's own, unless collected)
  std::vector<UnitId> collected;          ///< payloads that were folded and are no longer needed
  std::optional<std::string> fold_state;  ///< after the fold, when anything was collected
  UnitId fold_next;                       ///< the next unit in the plan's order to be collected
  std::int64_t folded = 0;                ///< units folded by this commit; not stored
  std::vector<std::string> records;       ///< appended to the job's records in this order
  double work_done = 0;                   ///< of the whole job
  double unit_seconds = 0;                ///< of the whole job
};

/// Where a job's plan stands: all that is needed to go on with it.
struct Progress {
  std::vector<ChainPosition> chains;  ///< only those that have begun, by chain
  std::vector<PendingPayload> pending;
  std::string fold_state;
  UnitId fold_next;
};

/// What Create may return in place of a new job: one of the same owner, specification and engine
/// version that has succeeded, or one that has not ended either.
enum class Reuse { kNothing, kAnswers, kAnswersAndUnfinished };

struct JobFilter {
  std::optional<std::string> owner;  ///< only theirs
  std::vector<JobState> states;      ///< empty: all
};

/// What is kept of jobs that have ended.
struct Retention {
  absl::Duration records = absl::InfiniteDuration();  ///< of a job, from its end on
  absl::Duration jobs = absl::InfiniteDuration();     ///< with their results
  /// Above this size, records are dropped: those of the job that ended first are the first.
  std::int64_t bytes = std::numeric_limits<std::int64_t>::max();
};

/// What survives a power cut. The death of the process takes nothing, either way.
enum class Synchronous {
  kNormal = 1,  ///< the store is sound; the last commits may be gone
  kFull = 2,    ///< every commit that was answered, where the disk keeps its word
};

struct StoreStats {
  std::map<JobState, std::int64_t> jobs;
  std::int64_t bytes = 0;                          ///< that are in use; the file may be larger
  Synchronous synchronous = Synchronous::kNormal;  ///< as the medium says
};

struct JobPage {
  std::vector<Job> jobs;  ///< the newest first
  std::string next_page_token;
};

/// Keeps jobs, their records, checkpoints and results. Safe to use from many threads. NOT_FOUND
/// where a job does not exist; INTERNAL, RESOURCE_EXHAUSTED (full disk) or DATA_LOSS (corrupt)
/// where the medium fails.
class JobStore {
 public:
  virtual ~JobStore() = default;

  /// Adds a job, or returns what may be used again. An owner's non-empty `request_id` always gives
  /// the job that it gave first: ALREADY_EXISTS when that one has another specification, or `reuse`
  /// was another. `room` not OK: there is none for a new job, and why.
  virtual absl::StatusOr<Job> Create(const Job& job, std::string_view request_id, Reuse reuse,
                                     const absl::Status& room) = 0;
  /// The job that Create would return in place of this one for the answer that it has given.
  virtual absl::StatusOr<std::optional<Job>> FindAnswer(const Job& job) const = 0;
  virtual absl::StatusOr<Job> Get(std::string_view id) const = 0;
  /// INVALID_ARGUMENT: the page token is not one of ours.
  virtual absl::StatusOr<JobPage> List(const JobFilter& filter, int page_size,
                                       std::string_view page_token) const = 0;
  /// Jobs that have not ended, the oldest first: what a server goes on with after a restart.
  virtual absl::StatusOr<std::vector<Job>> Unfinished() const = 0;
  virtual absl::Status Delete(std::string_view id) = 0;

  /// Makes a job that has not ended as if nothing of it had been computed, by another engine.
  virtual absl::Status Restart(std::string_view id, std::int64_t engine_version) = 0;
  /// What is in the store.
  virtual absl::StatusOr<StoreStats> Stats() const = 0;
  /// Drops what need not be kept at `now`; does part of it at a time, so that others get their
  /// turn: true when there is more to do.
  virtual absl::StatusOr<bool> Retain(const Retention& retention, absl::Time now) = 0;

  virtual absl::Status MarkStarted(std::string_view id, absl::Time now) = 0;
  /// Ends the job, once: FAILED_PRECONDITION when it has ended already. Drops checkpoints and
  /// pending payloads.
  virtual absl::Status MarkEnded(std::string_view id, JobState state, const absl::Status& error,
                                 std::string_view result, absl::Time now) = 0;

  virtual absl::Status Commit(std::string_view id, const UnitCommit& commit) = 0;
  virtual absl::StatusOr<Progress> LoadProgress(std::string_view id) const = 0;

  /// Records with a sequence number greater than `after`, in order, as many as fit into `max_bytes`
  /// but at least one if there is any. OUT_OF_RANGE: some of them were dropped.
  virtual absl::StatusOr<std::vector<StoredRecord>> Records(std::string_view id, std::int64_t after,
                                                            std::size_t max_bytes) const = 0;
};

}  // namespace celt::jobs
