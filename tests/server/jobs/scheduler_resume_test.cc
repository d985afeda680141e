#include <atomic>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/synchronization/notification.h"
#include "gtest/gtest.h"
#include "jobs/faulty_store.h"
#include "jobs/scheduler_testing.h"
#include "jobs/toy_plan.h"
#include "server/jobs/scheduler.h"

namespace celt::jobs {
namespace {

/// Runs until the unit is reached, shuts down inside it, and goes on with a new scheduler on the
/// same store.
Answer InterruptAt(UnitId where, int workers) {
  absl::Notification reached;
  Toy interrupted = Uneven();
  interrupted.on_run = [&](UnitId unit, const StopRequested& stop) {
    if (unit != where) return absl::OkStatus();
    reached.Notify();
    return RunUntilStopped(stop);
  };
  const auto store = MemoryStore();
  std::string id;
  {
    Scheduler scheduler(*store, ToyFactory({{"toy", interrupted}}), Workers(workers));
    EXPECT_TRUE(scheduler.Start().ok());
    id = Submit(scheduler, "toy");
    reached.WaitForNotification();
    scheduler.Shutdown();
    EXPECT_FALSE(HasEnded(store->Get(id)->state));
  }
  Scheduler scheduler(*store, ToyFactory({{"toy", Uneven()}}), Workers(workers));
  EXPECT_TRUE(scheduler.Start().ok());
  return AwaitEnd(scheduler, *store, id);
}

TEST(Scheduler, GoesOnAfterAnInterruptionAsIfThereHadBeenNone) {
  const Answer uninterrupted = ByDefinition(Uneven());
  for (const int workers : {1, 3}) {
    for (const UnitId where :
         {UnitId{0, 0}, UnitId{0, 5}, UnitId{2, 2}, UnitId{4, 1}, UnitId{8, 6}}) {
      EXPECT_EQ(InterruptAt(where, workers), uninterrupted)
          << workers << " workers, at " << where.step << "," << where.chain;
    }
  }
}

TEST(Scheduler, EndsAJobThatWasInterruptedJustBeforeItsEnd) {
  const auto store = MemoryStore();
  absl::Notification reached;
  FaultyStore faulty(*store, [&](std::string_view call) {
    if (call != "MarkEnded") return absl::OkStatus();
    if (!reached.HasBeenNotified()) reached.Notify();
    return absl::ResourceExhaustedError("the disk is full");
  });
  std::string id;
  {
    Scheduler scheduler(faulty, ToyFactory({{"toy", {}}}), Workers(1));
    ASSERT_TRUE(scheduler.Start().ok());
    id = Submit(scheduler, "toy");
    reached.WaitForNotification();
  }
  EXPECT_EQ(store->Get(id)->state, JobState::kRunning);
  Scheduler scheduler(*store, ToyFactory({{"toy", {}}}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  EXPECT_EQ(AwaitEnd(scheduler, *store, id), ByDefinition({}));
}

TEST(Scheduler, WaitsForAStoreThatFailsForAWhile) {
  const auto store = MemoryStore();
  std::atomic<int> calls = 0;
  FaultyStore faulty(*store, [&](std::string_view) {
    return ++calls % 3 == 0 ? absl::OkStatus() : absl::ResourceExhaustedError("the disk is full");
  });
  std::atomic<int> told = 0;
  SchedulerOptions options = Workers(3);
  options.store_retry = absl::ZeroDuration();
  options.on_error = [&](std::string_view, const absl::Status&) { ++told; };
  Scheduler scheduler(faulty, ToyFactory({{"toy", Uneven()}}), options);
  ASSERT_TRUE(scheduler.Start().ok());
  EXPECT_EQ(AwaitEnd(scheduler, *store, Submit(scheduler, "toy")), ByDefinition(Uneven()));
  EXPECT_GT(told, 0);
}

TEST(Scheduler, LeavesAJobAsItIsWhenTheStoreHasLostIt) {
  const auto store = MemoryStore();
  absl::Notification lost;
  FaultyStore faulty(*store, [&](std::string_view call) {
    return call == "Commit" ? absl::DataLossError("corrupt") : absl::OkStatus();
  });
  SchedulerOptions options = Workers(1);
  options.on_error = [&](std::string_view, const absl::Status&) {
    if (!lost.HasBeenNotified()) lost.Notify();
  };
  Scheduler scheduler(faulty, ToyFactory({{"toy", {}}}), options);
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string id = Submit(scheduler, "toy");
  lost.WaitForNotification();
  scheduler.Shutdown();
  EXPECT_EQ(store->Get(id)->state, JobState::kRunning);
  EXPECT_EQ(store->Get(id)->work_done, 0);
}

TEST(Scheduler, FailsAJobThatThisVersionCanNotGoOnWithAndStarts) {
  const auto store = MemoryStore();
  std::string old;
  std::string fine;
  {
    Scheduler scheduler(*store, ToyFactory({{"old", {}}, {"toy", {}}}), Workers(1));
    old = Submit(scheduler, "old");
    fine = Submit(scheduler, "toy");
  }
  Scheduler scheduler(*store, ToyFactory({{"toy", {}}}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  EXPECT_EQ(store->Get(old)->state, JobState::kFailed);
  EXPECT_EQ(AwaitEnd(scheduler, *store, fine).state, JobState::kSucceeded);
}

}  // namespace
}  // namespace celt::jobs
