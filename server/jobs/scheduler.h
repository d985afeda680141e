#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "server/jobs/forecast.h"
#include "server/jobs/limits.h"
#include "server/jobs/notifier.h"
#include "server/jobs/plan.h"
#include "server/jobs/store.h"
#include "server/jobs/turns.h"

namespace celt::jobs {

/// Twelve letters and digits at random: nobody guesses another's job.
std::string RandomJobId();

/// UNAVAILABLE, for who comes while the server goes down.
absl::Status ShuttingDown();

/// What a job asks of a server when nothing is known of its kind.
Load LoadOfAnyKind(std::string_view specification, const Plan& plan);

/// A unit that was computed and committed.
struct UnitDone {
  std::string_view job;
  absl::Duration took;
  double work = 0;  ///< in `work_unit`
  std::string_view work_unit;
};

struct SchedulerOptions {
  int workers = 0;  ///< threads that compute; 0: as many as there are cores
  /// One thread more, for jobs that have computed less than that, are not being computed, and find
  /// every worker busy: a short one need not wait for a long one's unit to end. 0: none.
  absl::Duration express = absl::ZeroDuration();
  /// Answers of one version are the same bytes, so that a job that was begun by another begins
  /// anew.
  std::int64_t engine_version = 0;
  /// Jobs of an earlier run sleep until somebody submits the same again, or follows them: for a
  /// service that lives as long as one question.
  bool on_demand = false;
  JobLimits limits;
  std::function<Load(std::string_view specification, const Plan& plan)> load = LoadOfAnyKind;
  std::int64_t run_ahead = 64;  ///< units of a job that may be done before they can be folded
  std::function<absl::Time()> clock = absl::Now;
  std::function<std::string()> new_id = RandomJobId;
  /// Told of a store that fails to take what was computed (it is tried again until it does), and of
  /// a job that could not be gone on with.
  std::function<void(std::string_view job, const absl::Status& error)> on_error =
      [](std::string_view, const absl::Status&) {};
  std::function<void(const UnitDone&)> on_unit = [](const UnitDone&) {};
  /// Told of a job that has ended, and how.
  std::function<void(std::string_view job, JobState state, const absl::Status& error)> on_end =
      [](std::string_view, JobState, const absl::Status&) {};
  absl::Duration store_retry = absl::Seconds(1);  ///< pause before a failed commit is tried again
};

/// A job as it is asked for.
struct Submission {
  std::string specification;  ///< resolved
  std::string owner = {};     ///< empty where there are no owners
  std::string request_id = {};
  bool fresh = false;  ///< compute, although the answer may be in the store
};

/// Runs jobs on a pool of threads. Owners share its time evenly, and an owner's jobs do, however
/// long their units are; within a job the lowest ready unit in the plan's order goes first.
/// Payloads are folded in the plan's order and committed with their unit, so that records and
/// result do not depend on threads or interruptions. Safe to use from many threads.
///
/// A job whose unit fails becomes FAILED once everything before that unit is folded; which unit's
/// error it shows, and its records, are therefore always the same.
class Scheduler {
 public:
  /// `store` must outlive this.
  Scheduler(JobStore& store, PlanFactory factory, SchedulerOptions options);
  /// Shuts down.
  ~Scheduler();
  Scheduler(const Scheduler&) = delete;
  Scheduler& operator=(const Scheduler&) = delete;

  /// Goes on with the jobs in the store that have not ended, unless they sleep, and starts the
  /// threads. Once, before the first Submit.
  absl::Status Start();
  /// Stops, inside running units too, and joins the threads. Nothing that was committed is lost:
  /// unfinished jobs stay so in the store and go on at the next start. Idempotent.
  void Shutdown();

  /// Accepts a job; its plan is made first, so that a wrong specification is refused with the
  /// factory's error. Unless it is to be fresh, a job that has given the answer is returned
  /// instead. `request_id` as in JobStore::Create. RESOURCE_EXHAUSTED: there are too many jobs, its
  /// payload kRetrySecondsPayload says when to try again. UNAVAILABLE once Shutdown has begun.
  absl::StatusOr<Job> Submit(const Submission& submission);
  /// The job that Submit would return in place of this one, because it has given the answer.
  absl::StatusOr<std::optional<Job>> FindAnswer(const Submission& submission) const;
  /// What a job would take, and nothing else: errors as of Submit, which accepts it.
  absl::StatusOr<Estimate> Foretell(const std::string& specification) const;
  /// Goes on with a sleeping job: for those who follow it. Nothing to do is no error.
  absl::Status Wake(std::string_view id);
  /// Asks the job to stop and returns it as it is now: CANCELLED already when no unit of it was
  /// running.
  absl::StatusOr<Job> Cancel(std::string_view id);
  /// Removes the job from the store at once, and stops it if it runs.
  absl::Status Delete(std::string_view id);

  /// Tells of new records, states and progress, and of removal.
  Notifier& notifier() { return notifier_; }
  /// How long jobs are expected to take.
  const Forecast& forecast() const { return forecast_; }
  int workers() const { return workers_; }
  const JobLimits& limits() const { return options_.limits; }
  /// Jobs that run or wait for a thread.
  std::int64_t active_jobs();
  bool stopping() const { return stopping_; }

 private:
  struct ActiveJob;
  struct Task;
  enum class Lane { kAny, kExpress };  // which jobs a thread is for
  using JobPointer = std::shared_ptr<ActiveJob>;

  absl::Status Learn();
  absl::Status Resume(Job job);
  absl::Status WakeUnderMutex(std::string_view id);
  absl::Status Room(const std::string& owner);
  void Deactivate(const JobPointer& job);
  absl::Status CancelSleeping(std::string_view id);
  void Activate(const Job& job, std::unique_ptr<Plan> plan, const Progress& progress);

  void Work(Lane lane);
  bool TakeTask(Lane lane, Task& task);
  void TakeUnit(const JobPointer& job, Task& task);
  bool HasTurn(Lane lane, const JobPointer& job) const;
  void List(const JobPointer& job);
  void RunTask(const Task& task);
  void CommitUnit(const Task& task, UnitOutput output, absl::Duration took);
  absl::Status CheckLimits(const ActiveJob& job) const;
  void FailUnit(const Task& task, const absl::Status& error);
  bool ClaimClosing(ActiveJob& job) const;
  void Settle(const JobPointer& job);

  void Close(const JobPointer& job);
  absl::Status End(ActiveJob& job);
  void Forget(const JobPointer& job);
  absl::Status Persist(ActiveJob& job, const std::function<absl::Status()>& write);

  JobStore& store_;
  const PlanFactory factory_;
  const SchedulerOptions options_;
  const int workers_;
  Notifier notifier_;
  Forecast forecast_;

  std::mutex activation_mutex_;  // held from the look at the store until the job is active
  std::atomic<bool> stopping_ = false;
  std::mutex mutex_;
  std::condition_variable listed_or_stopping_;   // what workers wait for
  std::condition_variable express_or_stopping_;  // what the express thread waits for
  std::condition_variable give_up_;  // what a pause before trying the store again waits for
  std::map<std::string, JobPointer, std::less<>> active_;  // under mutex_
  std::map<std::string, std::int64_t> unfinished_;         // jobs by owner; under mutex_
  Turns<JobPointer> listed_;                               // jobs with a ready unit; under mutex_
  int busy_ = 0;                                           // workers with a task; under mutex_
  std::vector<std::thread> threads_;                       // under shutdown_mutex_
  std::mutex shutdown_mutex_;
};

}  // namespace celt::jobs
