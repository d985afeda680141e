#include "server/jobs/fold.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/toy_plan.h"

namespace celt::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

UnitOutput Output(const std::string& payload, bool ended = false) {
  return {.checkpoint = "at " + payload, .payload = payload, .work = 2, .chain_ended = ended};
}

ChainPosition At(UnitId unit) { return {unit.chain, unit.step, "", false}; }

TEST(Fold, FoldsAUnitThatIsNextAtOnce) {
  const ToyPlan plan({.chains = 2, .steps = 2});
  Fold fold(plan, {}, 10);
  const auto commit = fold.Add(At({0, 0}), Output("a"));
  ASSERT_TRUE(commit.ok());
  EXPECT_EQ(commit->fold_state, "[a]");
  EXPECT_EQ(commit->fold_next, (UnitId{0, 1}));
  EXPECT_THAT(commit->added, IsEmpty());
  EXPECT_EQ(commit->work_done, 12);
  EXPECT_EQ(commit->position.next_step, 1);
  EXPECT_EQ(commit->position.checkpoint, "at a");
}

TEST(Fold, KeepsAUnitUntilItIsItsTurn) {
  const ToyPlan plan({.chains = 2, .steps = 2});
  Fold fold(plan, {}, 0);
  const auto early = fold.Add(At({0, 1}), Output("b"));
  ASSERT_TRUE(early.ok());
  EXPECT_FALSE(early->fold_state.has_value());
  EXPECT_EQ(early->added.size(), 1U);
  const auto late = fold.Add(At({0, 0}), Output("a"));
  ASSERT_TRUE(late.ok());
  EXPECT_EQ(late->fold_state, "[a][b]");
  EXPECT_THAT(late->collected, ElementsAre(UnitId{0, 1}));
  EXPECT_EQ(late->folded, 2);
  EXPECT_EQ(late->fold_next, (UnitId{1, 0}));
}

TEST(Fold, GoesOnFromWhatWasStored) {
  const ToyPlan plan({.chains = 2, .steps = 1});
  Progress progress;
  progress.pending = {{UnitId{0, 1}, "b"}};
  progress.fold_state = "before";
  Fold fold(plan, progress, 0);
  const auto commit = fold.Add(At({0, 0}), Output("a"));
  ASSERT_TRUE(commit.ok());
  EXPECT_EQ(commit->fold_state, "before[a][b]");
  EXPECT_EQ(commit->fold_next, (UnitId{1, 0}));
}

TEST(Fold, SkipsChainsThatHaveEnded) {
  const ToyPlan plan({.chains = 2, .steps = 3});
  Fold fold(plan, {}, 0);
  ASSERT_TRUE(fold.Add(At({0, 0}), Output("a", true)).ok());
  ASSERT_TRUE(fold.Add(At({0, 1}), Output("b")).ok());
  const auto commit = fold.Add(At({1, 1}), Output("c", true));
  ASSERT_TRUE(commit.ok());
  EXPECT_EQ(commit->fold_state, "[a][b][c]");
  EXPECT_EQ(commit->fold_next, (UnitId{3, 0})) << "nothing is left once every chain has ended";
}

TEST(Fold, GivesTheSameInEveryOrder) {
  // Chain by chain the steps must come in order; how chains interleave is drawn.
  std::vector<std::int64_t> turns = {0, 0, 0, 1, 1, 1, 2, 2, 2};
  std::mt19937 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    std::shuffle(turns.begin(), turns.end(), random);
    const ToyPlan plan({.chains = 3, .steps = 3});
    Fold fold(plan, {}, 0);
    std::vector<std::int64_t> step(3, 0);
    for (const std::int64_t chain : turns) {
      const UnitId unit{step[chain]++, chain};
      ASSERT_TRUE(fold.Add(At(unit), Output(absl::StrCat(unit.step, chain))).ok());
    }
    EXPECT_EQ(fold.state(), "[00][01][02][10][11][12][20][21][22]");
  }
}

}  // namespace
}  // namespace celt::jobs
