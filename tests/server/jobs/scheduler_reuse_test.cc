// What a scheduler computes once, and what it goes on with.

#include <atomic>
#include <memory>
#include <string>
#include <utility>

#include "absl/synchronization/notification.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/scheduler_testing.h"
#include "jobs/toy_plan.h"

namespace celt::jobs {
namespace {

/// A toy that counts the units it runs.
Toy Counted(std::atomic<int>& runs) {
  Toy toy{.chains = 1, .steps = 3};
  toy.on_run = [&runs](UnitId, const StopRequested&) {
    ++runs;
    return absl::OkStatus();
  };
  return toy;
}

SchedulerOptions Options(std::int64_t engine_version, bool on_demand = false) {
  SchedulerOptions options;
  options.workers = 1;
  options.engine_version = engine_version;
  options.on_demand = on_demand;
  return options;
}

std::string SubmitOnce(Scheduler& scheduler) {
  const auto job = scheduler.Submit({.specification = "toy"});
  EXPECT_TRUE(job.ok()) << job.status();
  return job.ok() ? job->id : "";
}

TEST(SchedulerReuse, ComputesAnAnswerOnceUnlessAskedForAFreshOne) {
  std::atomic<int> runs = 0;
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"toy", Counted(runs)}}), Options(1));
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string id = SubmitOnce(scheduler);
  const Answer answer = AwaitEnd(scheduler, *store, id);
  EXPECT_EQ(SubmitOnce(scheduler), id);
  EXPECT_EQ(runs, 3);
  const std::string fresh = Submit(scheduler, "toy");
  EXPECT_NE(fresh, id);
  EXPECT_EQ(AwaitEnd(scheduler, *store, fresh), answer);
  EXPECT_EQ(runs, 6);
}

TEST(SchedulerReuse, ServesNoAnswerOfAnotherEngine) {
  const auto store = MemoryStore();
  std::string first;
  {
    Scheduler scheduler(*store, ToyFactory({{"toy", {}}}), Options(1));
    ASSERT_TRUE(scheduler.Start().ok());
    first = SubmitOnce(scheduler);
    AwaitEnd(scheduler, *store, first);
  }
  Scheduler scheduler(*store, ToyFactory({{"toy", {}}}), Options(2));
  ASSERT_TRUE(scheduler.Start().ok());
  EXPECT_NE(SubmitOnce(scheduler), first);
}

/// Leaves a job in the store of which one unit is done.
std::string Interrupted(JobStore& store, std::int64_t engine_version) {
  absl::Notification reached;
  Toy toy{.chains = 1, .steps = 3};
  toy.on_run = [&](UnitId unit, const StopRequested& stop) {
    if (unit.step == 0) return absl::OkStatus();
    reached.Notify();
    while (!stop()) std::this_thread::yield();
    return absl::CancelledError("stopped");
  };
  Scheduler scheduler(store, ToyFactory({{"toy", toy}}), Options(engine_version));
  EXPECT_TRUE(scheduler.Start().ok());
  std::string id = SubmitOnce(scheduler);
  reached.WaitForNotification();
  scheduler.Shutdown();
  EXPECT_FALSE(HasEnded(store.Get(id)->state));
  return id;
}

TEST(SchedulerReuse, BeginsAnewWhatAnotherEngineBegan) {
  for (const auto& [engine_version, expected_runs] : {std::pair{1, 2}, std::pair{2, 3}}) {
    const auto store = MemoryStore();
    const std::string id = Interrupted(*store, 1);
    std::atomic<int> runs = 0;
    Scheduler scheduler(*store, ToyFactory({{"toy", Counted(runs)}}), Options(engine_version));
    ASSERT_TRUE(scheduler.Start().ok());
    EXPECT_EQ(AwaitEnd(scheduler, *store, id).state, JobState::kSucceeded);
    EXPECT_EQ(runs, expected_runs);
    EXPECT_EQ(store->Get(id)->engine_version, engine_version);
  }
}

TEST(SchedulerReuse, LetsAJobOfAnEarlierRunSleepUntilTheSameIsAskedForAndGoesOnWithIt) {
  const auto store = MemoryStore();
  const std::string id = Interrupted(*store, 1);
  std::atomic<int> runs = 0;
  Scheduler scheduler(*store, ToyFactory({{"toy", Counted(runs)}, {"other", {}}}),
                      Options(1, true));
  ASSERT_TRUE(scheduler.Start().ok());
  // With one worker and jobs that take turns, it would have run by the end of the other.
  AwaitEnd(scheduler, *store, Submit(scheduler, "other"));
  EXPECT_EQ(runs, 0);
  EXPECT_EQ(SubmitOnce(scheduler), id);
  EXPECT_EQ(AwaitEnd(scheduler, *store, id).state, JobState::kSucceeded);
  EXPECT_EQ(runs, 2) << "the first of three units was done before";
}

TEST(SchedulerReuse, WakesASleepingJobForThoseWhoFollowIt) {
  const auto store = MemoryStore();
  const std::string id = Interrupted(*store, 1);
  Scheduler scheduler(*store, ToyFactory({{"toy", {.chains = 1, .steps = 3}}}), Options(1, true));
  ASSERT_TRUE(scheduler.Start().ok());
  EXPECT_TRUE(scheduler.Wake(id).ok());
  EXPECT_EQ(AwaitEnd(scheduler, *store, id).state, JobState::kSucceeded);
  EXPECT_TRUE(scheduler.Wake(id).ok()) << "nothing to do is no error";
}

TEST(SchedulerReuse, CancelsASleepingJob) {
  const auto store = MemoryStore();
  const std::string id = Interrupted(*store, 1);
  Scheduler scheduler(*store, ToyFactory({{"toy", {.chains = 1, .steps = 3}}}), Options(1, true));
  ASSERT_TRUE(scheduler.Start().ok());
  EXPECT_EQ(scheduler.Cancel(id)->state, JobState::kCancelled);
  EXPECT_NE(SubmitOnce(scheduler), id) << "a cancelled job is never served";
}

}  // namespace
}  // namespace celt::jobs
