#include "server/jobs/scheduler.h"

#include <algorithm>
#include <random>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/jobs/active_job.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

int CountWorkers(int asked) {
  if (asked > 0) return asked;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

absl::Status ShuttingDown() {
  return absl::UnavailableError("the server is shutting down; come back later");
}

}  // namespace

std::string RandomJobId() {
  constexpr std::string_view kLetters = "0123456789abcdefghjkmnpqrstvwxyz";
  constexpr int kLength = 12;
  std::random_device random;
  std::string id;
  for (int i = 0; i < kLength; ++i) id += kLetters[random() % kLetters.size()];
  return id;
}

Scheduler::Scheduler(JobStore& store, PlanFactory factory, SchedulerOptions options)
    : store_(store),
      factory_(std::move(factory)),
      options_(std::move(options)),
      workers_(CountWorkers(options_.workers)) {}

Scheduler::~Scheduler() { Shutdown(); }

absl::Status Scheduler::Start() {
  CELT_ASSIGN_OR_RETURN(const std::vector<Job> unfinished, store_.Unfinished());
  for (const Job& job : unfinished) CELT_RETURN_IF_ERROR(Resume(job));
  const std::lock_guard lock(shutdown_mutex_);
  for (int i = 0; i < workers_; ++i) threads_.emplace_back([this] { Work(); });
  return absl::OkStatus();
}

/// A job that this version can't go on with fails; that is no reason not to start.
absl::Status Scheduler::Resume(const Job& job) {
  absl::StatusOr<std::unique_ptr<Plan>> plan = factory_(job.specification);
  if (!plan.ok()) {
    options_.on_error(job.id, plan.status());
    return store_.MarkEnded(job.id, JobState::kFailed, plan.status(), "", options_.clock());
  }
  CELT_ASSIGN_OR_RETURN(const Progress progress, store_.LoadProgress(job.id));
  Activate(job, *std::move(plan), progress);
  return absl::OkStatus();
}

void Scheduler::Shutdown() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  listed_or_stopping_.notify_all();
  give_up_.notify_all();
  const std::lock_guard lock(shutdown_mutex_);
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

absl::StatusOr<Job> Scheduler::Submit(std::string_view specification, std::string_view request_id) {
  if (stopping_) return ShuttingDown();
  CELT_ASSIGN_OR_RETURN(std::unique_ptr<Plan> plan, factory_(specification));
  Job job;
  job.id = options_.new_id();
  job.request_id = std::string(request_id);
  job.specification = std::string(specification);
  job.work_total = plan->work().total;
  job.work_unit = plan->work().unit;
  job.created = options_.clock();
  CELT_ASSIGN_OR_RETURN(const Job stored, store_.Create(job));
  if (stored.id == job.id) Activate(job, std::move(plan), {});
  return stored;
}

void Scheduler::Activate(const Job& job, std::unique_ptr<Plan> plan, const Progress& progress) {
  const auto active =
      std::make_shared<ActiveJob>(job, std::move(plan), progress, options_.run_ahead);
  bool close = false;
  {
    const std::lock_guard lock(mutex_);
    active_.emplace(active->id, active);
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
  return store_.Get(id);
}

absl::Status Scheduler::Delete(std::string_view id) {
  CELT_RETURN_IF_ERROR(store_.Delete(id));
  // What still runs finds nothing left to commit to.
  Cancel(id).IgnoreError();
  notifier_.Notify(id);
  return absl::OkStatus();
}

}  // namespace celt::jobs
