#include "server/plans/run_plan.h"

#include <cstdint>
#include <limits>

#include "gtest/gtest.h"
#include "jobs/toy_plan.h"

namespace celt::plans {
namespace {

bool Never() { return false; }

TEST(RunPlan, RunsAndFoldsTheUnitsOfAllChainsStepByStep) {
  const jobs::ToyPlan plan({.chains = 2, .steps = 3, .lengths = {{1, 1}}});
  EXPECT_EQ(RunPlan(plan, Never).value(), "result:[0/0][1/0][0/0/1][0/0/1/2]");
}

/// Were the steps that are left counted to their end, this would not come back.
TEST(RunPlan, IsDoneWithTheLastChainHoweverManyStepsThePlanAllows) {
  constexpr std::int64_t kMany = std::numeric_limits<std::int64_t>::max();
  const jobs::ToyPlan plan({.chains = 2, .steps = kMany, .lengths = {{0, 2}, {1, 1}}});
  EXPECT_EQ(RunPlan(plan, Never).value(), "result:[0/0][1/0][0/0/1]");
}

TEST(RunPlan, StopsBetweenUnits) {
  const jobs::ToyPlan plan({.chains = 2, .steps = 3});
  EXPECT_TRUE(absl::IsCancelled(RunPlan(plan, [] { return true; }).status()));
}

}  // namespace
}  // namespace celt::plans
