#include "server/jobs/scheduler.h"

#include <algorithm>
#include <random>
#include <utility>

#include "absl/strings/cord.h"
#include "absl/strings/str_cat.h"
#include "server/jobs/active_job.h"
#include "server/jobs/status_details.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

int CountWorkers(int asked) {
  if (asked > 0) return asked;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

absl::Status Full(const std::string& why) {
  constexpr const char* kRetrySeconds = "5";
  absl::Status status = absl::ResourceExhaustedError(absl::StrCat(why, "; try again later"));
  status.SetPayload(kRetrySecondsPayload, absl::Cord(kRetrySeconds));
  return status;
}

/// A job with no more than what makes it the same as another: who asks, what, and of which engine.
Job Identified(const Submission& submission, std::int64_t engine_version) {
  Job job;
  job.owner = submission.owner;
  job.specification = submission.specification;
  job.engine_version = engine_version;
  return job;
}

}  // namespace

absl::Status ShuttingDown() {
  return absl::UnavailableError("the server is shutting down; come back later");
}

std::string RandomJobId() {
  constexpr std::string_view kLetters = "0123456789abcdefghjkmnpqrstvwxyz";
  constexpr int kLength = 12;
  std::random_device random;
  std::string id;
  for (int i = 0; i < kLength; ++i) id += kLetters[random() % kLetters.size()];
  return id;
}

Load LoadOfAnyKind(std::string_view /*specification*/, const Plan& plan) {
  Load load;
  load.effort = plan.work().total;
  load.threads = plan.chains();
  load.most_units = plan.chains() * plan.steps();
  return load;
}

Scheduler::Scheduler(JobStore& store, PlanFactory factory, SchedulerOptions options)
    : store_(store),
      factory_(std::move(factory)),
      options_(std::move(options)),
      workers_(CountWorkers(options_.workers)),
      forecast_(workers_) {}

Scheduler::~Scheduler() { Shutdown(); }

absl::Status Scheduler::Start() {
  CELT_RETURN_IF_ERROR(Learn());
  if (!options_.on_demand) {
    CELT_ASSIGN_OR_RETURN(const std::vector<Job> unfinished, store_.Unfinished());
    for (const Job& job : unfinished) CELT_RETURN_IF_ERROR(Resume(job));
  }
  const std::lock_guard lock(shutdown_mutex_);
  for (int i = 0; i < workers_; ++i) threads_.emplace_back([this] { Work(Lane::kAny); });
  if (options_.express > absl::ZeroDuration()) {
    threads_.emplace_back([this] { Work(Lane::kExpress); });
  }
  return absl::OkStatus();
}

/// How fast this server is, from its latest answers.
absl::Status Scheduler::Learn() {
  constexpr int kAnswers = 100;
  JobFilter filter;
  filter.states = {JobState::kSucceeded};
  CELT_ASSIGN_OR_RETURN(const JobPage latest, store_.List(filter, kAnswers, ""));
  for (auto job = latest.jobs.rbegin(); job != latest.jobs.rend(); ++job) {
    const absl::StatusOr<std::unique_ptr<Plan>> plan = factory_(job->specification);
    if (!plan.ok() || !(job->unit_seconds > 0)) continue;
    forecast_.Learn(options_.load(job->specification, **plan), absl::Seconds(job->unit_seconds));
  }
  return absl::OkStatus();
}

/// A job that this version can't go on with fails; that is no reason not to start.
absl::Status Scheduler::Resume(Job job) {
  absl::StatusOr<std::unique_ptr<Plan>> plan = factory_(job.specification);
  if (!plan.ok()) {
    options_.on_error(job.id, plan.status());
    return store_.MarkEnded(job.id, JobState::kFailed, plan.status(), "", options_.clock());
  }
  if (job.engine_version != options_.engine_version) {
    CELT_RETURN_IF_ERROR(store_.Restart(job.id, options_.engine_version));
    CELT_ASSIGN_OR_RETURN(job, store_.Get(job.id));
  }
  CELT_ASSIGN_OR_RETURN(const Progress progress, store_.LoadProgress(job.id));
  Activate(job, *std::move(plan), progress);
  return absl::OkStatus();
}

absl::Status Scheduler::Wake(std::string_view id) {
  if (!options_.on_demand || stopping_) return absl::OkStatus();
  const std::lock_guard lock(activation_mutex_);
  return WakeUnderMutex(id);
}

absl::Status Scheduler::WakeUnderMutex(std::string_view id) {
  {
    const std::lock_guard lock(mutex_);
    if (active_.find(id) != active_.end()) return absl::OkStatus();
  }
  const absl::StatusOr<Job> job = store_.Get(id);
  if (!job.ok() || HasEnded(job->state)) return absl::OkStatus();
  return Resume(*job);
}

void Scheduler::Shutdown() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  listed_or_stopping_.notify_all();
  express_or_stopping_.notify_all();
  give_up_.notify_all();
  const std::lock_guard lock(shutdown_mutex_);
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

absl::StatusOr<Job> Scheduler::Submit(const Submission& submission) {
  if (stopping_) return ShuttingDown();
  CELT_ASSIGN_OR_RETURN(std::unique_ptr<Plan> plan, factory_(submission.specification));
  Job job = Identified(submission, options_.engine_version);
  job.id = options_.new_id();
  job.work_total = plan->work().total;
  job.work_unit = plan->work().unit;
  job.created = options_.clock();
  Reuse reuse = options_.on_demand ? Reuse::kAnswersAndUnfinished : Reuse::kAnswers;
  if (submission.fresh) reuse = Reuse::kNothing;
  const std::lock_guard lock(activation_mutex_);
  CELT_ASSIGN_OR_RETURN(Job stored,
                        store_.Create(job, submission.request_id, reuse, Room(job.owner)));
  if (stored.id == job.id) {
    Activate(job, std::move(plan), {});
  } else if (options_.on_demand) {
    CELT_RETURN_IF_ERROR(WakeUnderMutex(stored.id));
  }
  return stored;
}

absl::StatusOr<std::optional<Job>> Scheduler::FindAnswer(const Submission& submission) const {
  if (submission.fresh) return std::nullopt;
  return store_.FindAnswer(Identified(submission, options_.engine_version));
}

absl::StatusOr<Estimate> Scheduler::Foretell(const std::string& specification) const {
  if (stopping_) return ShuttingDown();
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<Plan> plan, factory_(specification));
  return forecast_.Of(options_.load(specification, *plan));
}

std::int64_t Scheduler::active_jobs() {
  const std::lock_guard lock(mutex_);
  return std::ssize(active_);
}

/// Whether there is room for a new job of the owner's.
absl::Status Scheduler::Room(const std::string& owner) {
  const JobLimits& limits = options_.limits;
  const std::lock_guard lock(mutex_);
  if (std::ssize(active_) >= limits.unfinished) {
    return Full(absl::StrCat("the queue is full: ", active_.size(), " jobs have not ended"));
  }
  const auto own = unfinished_.find(owner);
  if (own == unfinished_.end() || own->second < limits.unfinished_per_owner) {
    return absl::OkStatus();
  }
  return Full(absl::StrCat(own->second, " jobs of yours have not ended, which is the limit"));
}

/// Under mutex_.
void Scheduler::Deactivate(const JobPointer& job) {
  if (active_.erase(job->id) == 0) return;
  forecast_.End(job->id);
  listed_.Forget(job->owner, job);
  const auto own = unfinished_.find(job->owner);
  if (--own->second == 0) unfinished_.erase(own);
}

void Scheduler::Activate(const Job& job, std::unique_ptr<Plan> plan, const Progress& progress) {
  forecast_.Begin(job.id, options_.load(job.specification, *plan),
                  job.work_total > 0 ? job.work_done / job.work_total : 0);
  const auto active =
      std::make_shared<ActiveJob>(job, std::move(plan), progress, options_.run_ahead);
  bool close = false;
  {
    const std::lock_guard lock(mutex_);
    active_.emplace(active->id, active);
    ++unfinished_[active->owner];
    List(active);
    // An empty plan, or one that was interrupted between its last unit and its end.
    close = ClaimClosing(*active);
  }
  if (close) Close(active);
}

absl::StatusOr<Job> Scheduler::Cancel(std::string_view id) {
  JobPointer to_close;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = active_.find(id); found != active_.end() && !found->second->closing) {
      found->second->cancelled = true;
      found->second->stop = true;
      if (ClaimClosing(*found->second)) to_close = found->second;
    }
  }
  give_up_.notify_all();
  if (to_close) Close(to_close);
  CELT_RETURN_IF_ERROR(CancelSleeping(id));
  return store_.Get(id);
}

absl::Status Scheduler::CancelSleeping(std::string_view id) {
  if (!options_.on_demand) return absl::OkStatus();
  const std::lock_guard lock(activation_mutex_);
  {
    const std::lock_guard active_lock(mutex_);
    if (active_.find(id) != active_.end()) return absl::OkStatus();
  }
  CELT_ASSIGN_OR_RETURN(const Job job, store_.Get(id));
  if (HasEnded(job.state)) return absl::OkStatus();
  return store_.MarkEnded(id, JobState::kCancelled, absl::OkStatus(), "", options_.clock());
}

absl::Status Scheduler::Delete(std::string_view id) {
  CELT_RETURN_IF_ERROR(store_.Delete(id));
  // What still runs finds nothing left to commit to.
  Cancel(id).IgnoreError();
  notifier_.Notify(id);
  return absl::OkStatus();
}

}  // namespace celt::jobs
