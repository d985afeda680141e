#include "server/jobs/scheduler.h"

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "absl/synchronization/notification.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/faulty_store.h"
#include "jobs/scheduler_testing.h"
#include "jobs/toy_plan.h"

namespace celt::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Chains of different lengths, so that the fold has to skip.
Toy Uneven() { return {.chains = 7, .steps = 9, .lengths = {{2, 3}, {5, 1}}}; }

SchedulerOptions Workers(int workers) {
  SchedulerOptions options;
  options.workers = workers;
  options.run_ahead = 5;
  return options;
}

/// The answer by the definition: unit after unit in the plan's order.
Answer ByDefinition(const Toy& toy) {
  const ToyPlan plan(toy);
  std::map<std::int64_t, UnitOutput> chains;
  std::string state;
  Answer answer;
  for (UnitId unit; unit.step < plan.steps(); ++unit.step) {
    for (unit.chain = 0; unit.chain < plan.chains(); ++unit.chain) {
      UnitOutput& chain = chains[unit.chain];
      if (chain.chain_ended) continue;
      chain = *plan.Run(unit, chain.checkpoint, [] { return false; });
      Collected collected = *plan.Collect(unit, state, chain.payload);
      state = collected.state;
      answer.records.insert(answer.records.end(), collected.records.begin(),
                            collected.records.end());
    }
  }
  answer.state = JobState::kSucceeded;
  answer.error = absl::OkStatus().ToString();
  answer.result = *plan.Finish(state);
  return answer;
}

/// Waits inside a unit until it is told to stop.
absl::Status RunUntilStopped(const StopRequested& stop) {
  while (!stop()) std::this_thread::yield();
  return absl::CancelledError("stopped");
}

TEST(Scheduler, GivesTheAnswerOfThePlanWhateverTheThreads) {
  for (const int workers : {1, 2, 4}) {
    const auto store = MemoryStore();
    Scheduler scheduler(*store, ToyFactory({{"toy", Uneven()}}), Workers(workers));
    ASSERT_TRUE(scheduler.Start().ok());
    const std::string id = Submit(scheduler, "toy");
    EXPECT_EQ(AwaitEnd(scheduler, *store, id), ByDefinition(Uneven())) << workers << " workers";
    EXPECT_EQ(store->Get(id)->work_done, store->Get(id)->work_total);
  }
}

TEST(Scheduler, RunsTheUnitsOfAJobInThePlansOrder) {
  std::vector<UnitId> units;
  Toy toy{.chains = 2, .steps = 2};
  toy.on_run = [&](UnitId unit, const StopRequested&) {
    units.push_back(unit);
    return absl::OkStatus();
  };
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"toy", toy}}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  AwaitEnd(scheduler, *store, Submit(scheduler, "toy"));
  EXPECT_THAT(units, ElementsAre(UnitId{0, 0}, UnitId{0, 1}, UnitId{1, 0}, UnitId{1, 1}));
}

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

TEST(Scheduler, RefusesAWrongSpecificationAndKeepsNothing) {
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  EXPECT_TRUE(absl::IsInvalidArgument(scheduler.Submit({"toy"}).status()));
  EXPECT_THAT(store->List({}, 1, "")->jobs, IsEmpty());
}

TEST(Scheduler, RunsARequestOnce) {
  std::atomic<int> runs = 0;
  Toy toy{.chains = 1, .steps = 1};
  toy.on_run = [&](UnitId, const StopRequested&) {
    ++runs;
    return absl::OkStatus();
  };
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"toy", toy}, {"other", toy}}), Workers(2));
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string id = Submit(scheduler, "toy", "request");
  EXPECT_EQ(Submit(scheduler, "toy", "request"), id);
  EXPECT_TRUE(absl::IsAlreadyExists(TrySubmit(scheduler, "other", "request").status()));
  AwaitEnd(scheduler, *store, id);
  EXPECT_EQ(Submit(scheduler, "toy", "request"), id) << "also when it has ended";
  EXPECT_EQ(runs, 1);
}

TEST(Scheduler, EndsAPlanWithoutUnits) {
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"toy", {.chains = 0, .steps = 0}}}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  EXPECT_EQ(AwaitEnd(scheduler, *store, Submit(scheduler, "toy")).result, "result:");
}

TEST(Scheduler, CancelsAtOnceAJobOfWhichNothingRuns) {
  absl::Notification go_on;
  Toy busy{.chains = 1, .steps = 1};
  busy.on_run = [&](UnitId, const StopRequested&) {
    go_on.WaitForNotification();
    return absl::OkStatus();
  };
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"busy", busy}, {"toy", {}}}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string first = Submit(scheduler, "busy");
  AwaitJob(scheduler, first, [&] { return store->Get(first)->state == JobState::kRunning; });
  const std::string queued = Submit(scheduler, "toy");
  const auto cancelled = scheduler.Cancel(queued);
  EXPECT_EQ(cancelled->state, JobState::kCancelled);
  go_on.Notify();
  EXPECT_EQ(AwaitEnd(scheduler, *store, first).state, JobState::kSucceeded);
}

TEST(Scheduler, CancelsInsideARunningUnitAndKeepsTheRecords) {
  absl::Notification running;
  Toy toy{.chains = 1, .steps = 4};
  toy.on_run = [&](UnitId unit, const StopRequested& stop) {
    if (unit.step < 2) return absl::OkStatus();
    running.Notify();
    return RunUntilStopped(stop);
  };
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"toy", toy}}), Workers(2));
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string id = Submit(scheduler, "toy");
  running.WaitForNotification();
  ASSERT_TRUE(scheduler.Cancel(id).ok());
  const Answer answer = AwaitEnd(scheduler, *store, id);
  EXPECT_EQ(answer.state, JobState::kCancelled);
  EXPECT_THAT(answer.records, ElementsAre("0/0/1#0"));
  EXPECT_EQ(scheduler.Cancel(id)->state, JobState::kCancelled) << "again, without effect";
}

TEST(Scheduler, KnowsNoJobToCancelThatWasNotSubmitted) {
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({}), Workers(1));
  EXPECT_TRUE(absl::IsNotFound(scheduler.Cancel("nobody").status()));
  EXPECT_TRUE(absl::IsNotFound(scheduler.Delete("nobody")));
}

TEST(Scheduler, DeletesARunningJobAtOnceAndGoesOn) {
  absl::Notification running;
  Toy toy{.chains = 1, .steps = 1};
  toy.on_run = [&](UnitId, const StopRequested& stop) {
    running.Notify();
    return RunUntilStopped(stop);
  };
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"stuck", toy}, {"toy", {}}}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string id = Submit(scheduler, "stuck");
  running.WaitForNotification();
  EXPECT_TRUE(scheduler.Delete(id).ok());
  EXPECT_TRUE(absl::IsNotFound(store->Get(id).status()));
  EXPECT_EQ(AwaitEnd(scheduler, *store, Submit(scheduler, "toy")).state, JobState::kSucceeded);
}

TEST(Scheduler, FailsWithTheFirstErrorInThePlanWhateverTheThreads) {
  Toy toy{.chains = 4, .steps = 5};
  toy.on_run = [](UnitId unit, const StopRequested&) {
    if (unit == UnitId{2, 1} || unit == UnitId{2, 3} || unit == UnitId{3, 0}) {
      return absl::OutOfRangeError(absl::StrCat("lost at ", unit.step, ",", unit.chain));
    }
    return absl::OkStatus();
  };
  std::vector<Answer> answers;
  for (const int workers : {1, 4}) {
    const auto store = MemoryStore();
    Scheduler scheduler(*store, ToyFactory({{"toy", toy}}), Workers(workers));
    ASSERT_TRUE(scheduler.Start().ok());
    answers.push_back(AwaitEnd(scheduler, *store, Submit(scheduler, "toy")));
  }
  EXPECT_EQ(answers[0].state, JobState::kFailed);
  EXPECT_EQ(answers[0].error, "OUT_OF_RANGE: lost at 2,1");
  EXPECT_THAT(answers[0].records, SizeIs(Gt(0)));
  EXPECT_EQ(answers[0], answers[1]);
}

TEST(Scheduler, FailsWhenThePlanCanNotFinish) {
  Toy toy;
  toy.on_finish = [] { return absl::InternalError("no end"); };
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"toy", toy}}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  const Answer answer = AwaitEnd(scheduler, *store, Submit(scheduler, "toy"));
  EXPECT_EQ(answer.state, JobState::kFailed);
  EXPECT_EQ(answer.error, "INTERNAL: no end");
}

TEST(Scheduler, TellsOfEveryCommitAndLetsTheCallbackCallBack) {
  const auto store = MemoryStore();
  absl::Notification go_on;
  Toy toy{.chains = 1, .steps = 4};
  toy.on_run = [&](UnitId, const StopRequested&) {
    go_on.WaitForNotification();
    return absl::OkStatus();
  };
  Scheduler scheduler(*store, ToyFactory({{"toy", toy}}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  const std::string id = Submit(scheduler, "toy");
  const auto subscription = scheduler.notifier().Subscribe(id, [&] {
    if (store->Get(id)->work_done >= 2) scheduler.Cancel(id).IgnoreError();
  });
  go_on.Notify();
  EXPECT_EQ(AwaitEnd(scheduler, *store, id).state, JobState::kCancelled);
  EXPECT_EQ(store->Get(id)->work_done, 2);
}

TEST(Scheduler, TakesNoMoreJobsOnceItShutsDown) {
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"toy", {}}}), Workers(1));
  ASSERT_TRUE(scheduler.Start().ok());
  scheduler.Shutdown();
  EXPECT_TRUE(absl::IsUnavailable(scheduler.Submit({"toy"}).status()));
}

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
