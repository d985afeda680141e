// The part of the scheduler that its threads run: take a unit, run it, commit it, end the job after
// the last.

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/jobs/active_job.h"
#include "server/jobs/scheduler.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

/// Errors of a store after which trying again is pointless: the job is gone or has ended, or its
/// data are.
bool IsFinal(const absl::Status& error) {
  return absl::IsNotFound(error) || absl::IsFailedPrecondition(error) || absl::IsDataLoss(error);
}

/// What a unit counts for at least, so that jobs of none but the shortest units take turns too.
constexpr absl::Duration kShortest = absl::Microseconds(1);

}  // namespace

void Scheduler::Work(Lane lane) {
  Task task;
  while (TakeTask(lane, task)) {
    RunTask(task);
    Settle(task.job);
    task = Task();
    if (lane == Lane::kExpress) continue;
    const std::lock_guard lock(mutex_);
    --busy_;
  }
}

/// Puts a job with a ready unit at the end of the line. Under mutex_.
void Scheduler::List(const JobPointer& job) {
  if (job->listed || job->stop || job->closing || !job->queue.HasReady()) return;
  job->listed = true;
  listed_.Push(job->owner, job);
  listed_or_stopping_.notify_one();
  express_or_stopping_.notify_one();
}

/// Whether a thread of that lane may take a unit of a listed job. Under mutex_.
bool Scheduler::HasTurn(Lane lane, const JobPointer& job) const {
  if (lane == Lane::kAny) return true;
  return busy_ == workers_ && job->running == 0 && job->computed < options_.express;
}

/// Waits for a unit; false when it is time to stop.
bool Scheduler::TakeTask(Lane lane, Task& task) {
  std::condition_variable& changed =
      lane == Lane::kExpress ? express_or_stopping_ : listed_or_stopping_;
  std::unique_lock lock(mutex_);
  while (!stopping_) {
    const auto next = listed_.Pop([&](const JobPointer& job) { return HasTurn(lane, job); });
    if (!next) {
      changed.wait(lock);
      continue;
    }
    const JobPointer& job = *next;
    job->listed = false;
    if (job->stop || job->closing || !job->queue.HasReady()) continue;
    if (lane == Lane::kAny) ++busy_;
    TakeUnit(job, task);
    return true;
  }
  return false;
}

/// Under mutex_.
void Scheduler::TakeUnit(const JobPointer& job, Task& task) {
  task.job = job;
  task.position = job->queue.Take();
  task.first = !std::exchange(job->started, true);
  ++job->running;
  // As long as the last one, until it is known.
  task.charged = std::max(job->last_took, kShortest);
  listed_.Charge(job->owner, job, absl::ToDoubleSeconds(task.charged));
  List(job);
  // One of those that wait on may be in a hurry, now that no worker is free.
  express_or_stopping_.notify_one();
}

void Scheduler::RunTask(const Task& task) {
  ActiveJob& job = *task.job;
  if (task.first) {
    const absl::Status marked =
        Persist(job, [&] { return store_.MarkStarted(job.id, options_.clock()); });
    if (!marked.ok()) return;
    notifier_.Notify(job.id);
  }
  const StopRequested stop = [&] { return stopping_ || job.stop; };
  const absl::Time began = options_.clock();
  absl::StatusOr<UnitOutput> output = job.plan->Run(task.unit(), task.position.checkpoint, stop);
  const absl::Duration took = options_.clock() - began;
  if (output.ok()) return CommitUnit(task, *std::move(output), took);
  // Interrupted: the unit will be run again at the next start, unless the job is cancelled.
  if (absl::IsCancelled(output.status()) && stop()) return;
  FailUnit(task, output.status());
}

void Scheduler::CommitUnit(const Task& task, UnitOutput output, absl::Duration took) {
  ActiveJob& job = *task.job;
  std::unique_lock fold_lock(job.fold_mutex);
  if (job.lost || job.stop) return;
  const double work = output.work;
  absl::StatusOr<UnitCommit> commit = job.fold.Add(task.position, std::move(output));
  if (!commit.ok()) {
    job.lost = true;
    return FailUnit(task, commit.status());
  }
  commit->unit_seconds = job.unit_seconds += absl::ToDoubleSeconds(took);
  job.records += std::ssize(commit->records);
  if (!Persist(job, [&] { return store_.Commit(job.id, *commit); }).ok()) {
    job.lost = true;
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    job.computed += took;
    job.last_took = took;
    listed_.Charge(job.owner, task.job,
                   absl::ToDoubleSeconds(std::max(took, kShortest) - task.charged));
    job.queue.Done(std::move(commit->position), commit->fold_next, commit->folded);
    if (const absl::Status limit = CheckLimits(job); !limit.ok() && !job.queue.Complete()) {
      job.queue.Failed(commit->fold_next, limit);
      // No other unit of the job may be folded after this one.
      job.stop = true;
    }
    List(task.job);
  }
  fold_lock.unlock();
  const double total = job.plan->work().total;
  forecast_.CountUnit(job.id, total > 0 ? work / total : 0, took);
  options_.on_unit({job.id, took, work, job.work_unit});
  notifier_.Notify(job.id);
}

absl::Status Scheduler::CheckLimits(const ActiveJob& job) const {
  const JobLimits& limits = options_.limits;
  if (absl::Seconds(job.unit_seconds) > limits.computing_time) {
    return absl::ResourceExhaustedError(absl::StrCat("it has computed for ",
                                                     absl::FormatDuration(limits.computing_time),
                                                     ", which is this server's limit"));
  }
  if (job.records <= limits.records) return absl::OkStatus();
  return absl::ResourceExhaustedError(
      absl::StrCat("it has more records than this server's limit of ", limits.records));
}

void Scheduler::FailUnit(const Task& task, const absl::Status& error) {
  const std::lock_guard lock(mutex_);
  task.job->queue.Failed(task.unit(), error);
}

/// Tries until the store takes it. Fails when that is hopeless or there is no more time, and then
/// the job's units are told to stop: the store keeps it as it was.
absl::Status Scheduler::Persist(ActiveJob& job, const std::function<absl::Status()>& write) {
  for (;;) {
    absl::Status status = write();
    if (status.ok()) return status;
    if (!absl::IsNotFound(status)) options_.on_error(job.id, status);
    std::unique_lock lock(mutex_);
    const auto give_up = [&] { return stopping_ || job.cancelled; };
    if (IsFinal(status) ||
        give_up_.wait_for(lock, absl::ToChronoMilliseconds(options_.store_retry), give_up)) {
      job.stop = true;
      return status;
    }
  }
}

/// Whether it is time to end the job, and for the caller to do so. Under mutex_.
bool Scheduler::ClaimClosing(ActiveJob& job) const {
  if (job.running > 0 || job.closing) return false;
  job.closing = job.stop || job.queue.Complete() || job.queue.failure().has_value();
  return job.closing;
}

/// After a task of the job, whatever came of it.
void Scheduler::Settle(const JobPointer& job) {
  bool close = false;
  {
    const std::lock_guard lock(mutex_);
    --job->running;
    // What comes after the failed unit is of no use to anybody.
    if (job->queue.failure()) job->stop = true;
    close = ClaimClosing(*job);
  }
  if (close) Close(job);
}

void Scheduler::Close(const JobPointer& job) {
  Persist(*job, [&] { return End(*job); }).IgnoreError();
  {
    const std::lock_guard lock(mutex_);
    Deactivate(job);
  }
  notifier_.Notify(job->id);
}

absl::Status Scheduler::End(ActiveJob& job) {
  JobState state = JobState::kCancelled;
  absl::Status error;
  std::string result;
  if (const std::optional<absl::Status> failure = job.queue.failure(); failure) {
    state = JobState::kFailed;
    error = *failure;
  } else if (job.queue.Complete()) {
    absl::StatusOr<std::string> finished = job.plan->Finish(job.fold.state());
    state = finished.ok() ? JobState::kSucceeded : JobState::kFailed;
    error = finished.status();
    result = finished.value_or("");
  } else if (!job.cancelled) {
    return absl::OkStatus();  // Lost for this run: the store keeps it unfinished.
  }
  CELT_RETURN_IF_ERROR(store_.MarkEnded(job.id, state, error, result, options_.clock()));
  options_.on_end(job.id, state, error);
  return absl::OkStatus();
}

}  // namespace celt::jobs
