#include "server/jobs/unit_queue.h"

#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/toy_plan.h"

namespace celt::jobs {
namespace {

using ::testing::ElementsAre;

constexpr std::int64_t kFar = 1000;

UnitId TakeUnit(UnitQueue& queue) {
  const ChainPosition position = queue.Take();
  return {position.next_step, position.chain};
}

ChainPosition After(UnitId unit) { return {unit.chain, unit.step + 1, "checkpoint", false}; }

TEST(UnitQueue, GivesTheLowestStepFirst) {
  const ToyPlan plan({.chains = 2, .steps = 2});
  UnitQueue queue(plan, {}, kFar);
  EXPECT_EQ(TakeUnit(queue), (UnitId{0, 0}));
  queue.Done(After({0, 0}), {0, 1}, 1);
  EXPECT_EQ(TakeUnit(queue), (UnitId{0, 1})) << "although chain 0 is ready for step 1";
  EXPECT_EQ(TakeUnit(queue), (UnitId{1, 0}));
  EXPECT_FALSE(queue.HasReady()) << "chain 1 is still running, chain 0 too";
}

TEST(UnitQueue, HandsOnTheCheckpoint) {
  const ToyPlan plan({.chains = 1, .steps = 2});
  UnitQueue queue(plan, {}, kFar);
  EXPECT_EQ(queue.Take().checkpoint, "");
  queue.Done(After({0, 0}), {1, 0}, 1);
  EXPECT_EQ(queue.Take().checkpoint, "checkpoint");
}

TEST(UnitQueue, RunsAheadOfTheFoldOnlySoFar) {
  const ToyPlan plan({.chains = 5, .steps = 1});
  UnitQueue queue(plan, {}, 3);
  const UnitId slow = TakeUnit(queue);
  for (int i = 0; i < 2; ++i) {
    const UnitId unit = TakeUnit(queue);
    queue.Done(After(unit), {0, 0}, 0);
  }
  EXPECT_FALSE(queue.HasReady());
  queue.Done(After(slow), {0, 3}, 3);
  EXPECT_TRUE(queue.HasReady());
}

TEST(UnitQueue, AlwaysGivesTheNextUnitToFold) {
  const ToyPlan plan({.chains = 4, .steps = 1});
  Progress progress;
  progress.chains = {{1, 1, "", false}, {2, 1, "", false}};
  progress.pending = {{UnitId{0, 1}, ""}, {UnitId{0, 2}, ""}};
  UnitQueue queue(plan, progress, 2);
  EXPECT_EQ(TakeUnit(queue), (UnitId{0, 0}));
  EXPECT_FALSE(queue.HasReady());
}

TEST(UnitQueue, GoesOnWithWhatHasNotBeenRun) {
  const ToyPlan plan({.chains = 4, .steps = 2});
  Progress progress;
  progress.chains = {{0, 2, "", false}, {2, 1, "two", false}};
  progress.fold_next = {0, 1};
  UnitQueue queue(plan, progress, kFar);
  std::vector<UnitId> units;
  while (queue.HasReady()) units.push_back(TakeUnit(queue));
  EXPECT_THAT(units, ElementsAre(UnitId{0, 1}, UnitId{0, 3}, UnitId{1, 2}));
}

TEST(UnitQueue, AfterAFailureBeginsOnlyWhatComesBefore) {
  const ToyPlan plan({.chains = 3, .steps = 2});
  UnitQueue queue(plan, {}, kFar);
  for (int i = 0; i < 3; ++i) TakeUnit(queue);
  queue.Done(After({0, 0}), {0, 1}, 1);
  queue.Failed({0, 2}, absl::OutOfRangeError("lost"));
  EXPECT_FALSE(queue.HasReady()) << "step 1 comes after the failed unit";
  EXPECT_FALSE(queue.failure().has_value()) << "chain 1 has not been folded yet";
  queue.Done(After({0, 1}), {0, 2}, 1);
  ASSERT_TRUE(queue.failure().has_value());
  EXPECT_EQ(*queue.failure(), absl::OutOfRangeError("lost"));
}

TEST(UnitQueue, OfTwoFailuresShowsTheOneThatComesFirstInThePlan) {
  const ToyPlan plan({.chains = 2, .steps = 1});
  UnitQueue queue(plan, {}, kFar);
  TakeUnit(queue);
  TakeUnit(queue);
  queue.Failed({0, 1}, absl::InternalError("second"));
  queue.Failed({0, 0}, absl::InternalError("first"));
  EXPECT_EQ(queue.failure(), absl::InternalError("first"));
}

TEST(UnitQueue, IsCompleteWhenEverythingIsFolded) {
  const ToyPlan plan({.chains = 1, .steps = 1});
  UnitQueue queue(plan, {}, kFar);
  EXPECT_FALSE(queue.Complete());
  TakeUnit(queue);
  queue.Done(After({0, 0}), {1, 0}, 1);
  EXPECT_TRUE(queue.Complete());
  EXPECT_FALSE(queue.HasReady());
}

}  // namespace
}  // namespace celt::jobs
