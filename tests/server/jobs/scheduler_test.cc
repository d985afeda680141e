#include "server/jobs/scheduler.h"

#include <atomic>
#include <string>
#include <vector>

#include "absl/synchronization/notification.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/scheduler_testing.h"
#include "jobs/toy_plan.h"

namespace celt::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::IsEmpty;
using ::testing::SizeIs;

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

}  // namespace
}  // namespace celt::jobs
