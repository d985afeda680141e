#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "server/jobs/fold.h"
#include "server/jobs/scheduler.h"
#include "server/jobs/unit_queue.h"

namespace celt::jobs {

/// A job that has not ended, in memory. The queue and what follows it are under the scheduler's
/// mutex, which is never held for long; the fold and what is counted beside it are under one of
/// their own, which is held while a unit is committed.
struct Scheduler::ActiveJob {
  ActiveJob(const Job& job, std::unique_ptr<Plan> its_plan, const Progress& progress,
            std::int64_t run_ahead)
      : id(job.id),
        owner(job.owner),
        work_unit(job.work_unit),
        plan(std::move(its_plan)),
        queue(*plan, progress, run_ahead),
        computed(absl::Seconds(job.unit_seconds)),
        started(job.state != JobState::kQueued),
        fold(*plan, progress, job.work_done),
        unit_seconds(job.unit_seconds),
        records(job.last_sequence) {}

  const std::string id;
  const std::string owner;
  const std::string work_unit;
  const std::unique_ptr<Plan> plan;
  std::atomic<bool> stop = false;  ///< its units are to stop: it is cancelled, deleted or lost

  UnitQueue queue;
  int running = 0;           ///< its tasks that a thread has taken
  absl::Duration computed;   ///< by its units, earlier runs included
  absl::Duration last_took;  ///< by the latest of them
  bool listed = false;       ///< it is in listed_
  bool started = false;      ///< somebody marks it as started in the store, or has
  bool cancelled = false;    ///< its owner wants no more of it
  bool closing = false;      ///< somebody ends it; nothing else may

  std::mutex fold_mutex;
  Fold fold;
  double unit_seconds;   ///< that its units have computed
  std::int64_t records;  ///< in the store
  bool lost = false;  ///< a commit was given up: memory is ahead of the store, nothing more may be
                      ///< committed
};

/// A unit to run, from its chain's position.
struct Scheduler::Task {
  JobPointer job;
  ChainPosition position;
  bool first = false;      ///< the job's first since it was submitted
  absl::Duration charged;  ///< already to its job, for the time it is expected to take

  UnitId unit() const { return {position.next_step, position.chain}; }
};

}  // namespace celt::jobs
