#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "absl/synchronization/notification.h"
#include "absl/time/time.h"
#include "gtest/gtest.h"
#include "jobs/scheduler_testing.h"
#include "jobs/toy_plan.h"
#include "server/jobs/scheduler.h"

namespace celt::jobs {
namespace {

TEST(Scheduler, LetsJobsShareTime) {
  absl::Notification both_submitted;
  std::string turns;
  std::atomic<int> seconds = 0;
  const auto taking = [&](char name, int its_seconds) {
    Toy toy{.chains = 1, .steps = 6 / its_seconds};
    toy.on_run = [&turns, &seconds, &both_submitted, name, its_seconds](UnitId,
                                                                        const StopRequested&) {
      both_submitted.WaitForNotification();
      turns += name;
      seconds += its_seconds;
      return absl::OkStatus();
    };
    return toy;
  };
  const auto store = MemoryStore();
  SchedulerOptions options = Workers(1);
  options.clock = [&] { return absl::FromUnixSeconds(seconds); };
  Scheduler scheduler(*store, ToyFactory({{"a", taking('a', 3)}, {"b", taking('b', 1)}}), options);
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string first = Submit(scheduler, "a");
  AwaitJob(scheduler, first, [&] { return store->Get(first)->state == JobState::kRunning; });
  const std::string second = Submit(scheduler, "b");
  both_submitted.Notify();
  AwaitEnd(scheduler, *store, first);
  AwaitEnd(scheduler, *store, second);
  EXPECT_EQ(turns, "abbbabbb");
}

TEST(Scheduler, EndsAShortJobWhileAllWorkersAreInLongUnits) {
  absl::Notification in_long_unit;
  absl::Notification short_job_ended;
  std::atomic<bool> waited_in_vain = false;
  Toy long_toy{.chains = 1, .steps = 1};
  long_toy.on_run = [&](UnitId, const StopRequested&) {
    in_long_unit.Notify();
    // Met only when the short job has to wait for this unit.
    waited_in_vain = !short_job_ended.WaitForNotificationWithTimeout(absl::Seconds(20));
    return absl::OkStatus();
  };
  const auto store = MemoryStore();
  SchedulerOptions options = Workers(1);
  options.express = absl::Seconds(1);
  Scheduler scheduler(
      *store, ToyFactory({{"long", long_toy}, {"short", {.chains = 2, .steps = 3}}}), options);
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string long_job = Submit(scheduler, "long");
  in_long_unit.WaitForNotification();
  const std::string short_job = Submit(scheduler, "short");
  EXPECT_EQ(AwaitEnd(scheduler, *store, short_job), ByDefinition({.chains = 2, .steps = 3}));
  short_job_ended.Notify();
  AwaitEnd(scheduler, *store, long_job);
  EXPECT_FALSE(waited_in_vain);
}

TEST(Scheduler, LeavesJobsThatHaveHadTheirTimeToTheWorkers) {
  absl::Notification in_long_unit;
  absl::Notification released;
  std::thread::id worker;
  Toy long_toy{.chains = 1, .steps = 1};
  long_toy.on_run = [&](UnitId, const StopRequested&) {
    worker = std::this_thread::get_id();
    in_long_unit.Notify();
    released.WaitForNotification();
    return absl::OkStatus();
  };
  std::atomic<int> seconds = 0;
  std::vector<std::thread::id> threads;
  Toy slow_toy{.chains = 1, .steps = 3};
  slow_toy.on_run = [&](UnitId, const StopRequested&) {
    threads.push_back(std::this_thread::get_id());
    seconds += 2;
    return absl::OkStatus();
  };
  const auto store = MemoryStore();
  SchedulerOptions options = Workers(1);
  options.clock = [&] { return absl::FromUnixSeconds(seconds); };
  options.express = absl::Seconds(3);
  Scheduler scheduler(
      *store, ToyFactory({{"long", long_toy}, {"slow", slow_toy}, {"short", {.chains = 1}}}),
      options);
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string long_job = Submit(scheduler, "long");
  in_long_unit.WaitForNotification();
  const std::string slow_job = Submit(scheduler, "slow");
  AwaitJob(scheduler, slow_job, [&] { return store->Get(slow_job)->work_done >= 2; });
  // While the express thread serves others, it passes the slow job by.
  for (int i = 0; i < 3; ++i) AwaitEnd(scheduler, *store, Submit(scheduler, "short"));
  EXPECT_EQ(store->Get(slow_job)->work_done, 2);
  released.Notify();
  AwaitEnd(scheduler, *store, slow_job);
  AwaitEnd(scheduler, *store, long_job);
  ASSERT_EQ(threads.size(), 3U);
  EXPECT_NE(threads[0], worker);
  EXPECT_NE(threads[1], worker);
  EXPECT_EQ(threads[2], worker) << "after four seconds, more than the express thread is for";
}

}  // namespace
}  // namespace celt::jobs
