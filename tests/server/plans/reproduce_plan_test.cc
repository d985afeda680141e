#include "server/plans/reproduce_plan.h"

#include <cmath>
#include <string>

#include "gtest/gtest.h"
#include "plans/plan_testing.h"
#include "server/plans/reproduce_items.h"
#include "server/plans/reproduce_rows.h"

namespace celt::plans {
namespace {

v1::ReproduceRecord Row(double printed, double printed_error, double computed, double error) {
  return MakeRow(NumberRow{.section = "1",
                           .quantity = "x",
                           .paper = "p",
                           .printed = printed,
                           .printed_error = printed_error,
                           .computed = computed,
                           .error = error});
}

TEST(ReproduceRows, AgreeWithinThePrintedDigitsAndThreeErrors) {
  EXPECT_EQ(Row(1, 0.01, 1.0099, 0).verdict(), v1::AGREES);
  EXPECT_EQ(Row(1, 0.01, 1.011, 0).verdict(), v1::DIFFERS);
  EXPECT_EQ(Row(1, 0.01, 1.039, 0.01).verdict(), v1::AGREES);
  EXPECT_EQ(Row(1, 0.01, 1.041, 0.01).verdict(), v1::DIFFERS);
  EXPECT_EQ(Row(1, 0.01, std::nan(""), 0.01).verdict(), v1::DIFFERS);
}

TEST(ReproduceRows, ShowTheDigitsThatTheErrorLeaves) {
  EXPECT_EQ(Digits(0.0253146, 0.0002), "0.02531");
  EXPECT_EQ(Digits(747.78555936943, 1e-9), "747.7855593694");
  EXPECT_EQ(Digits(1.5, 0), "1.5000000000");
  EXPECT_EQ(Digits(123.4, 50), "123");
}

/// Rows of an item, computed on the paper's stone in the paper's frame as a job does.
ReproduceRows Compute(absl::StatusOr<ReproduceRows> (*item)(const Reproduction&)) {
  const v1::JobSpec spec = Resolved("reproduce { quick: true }");
  const jobs::StopRequested never = [] { return false; };
  const auto rows = item(Reproduction(spec, true, never));
  EXPECT_TRUE(rows.ok()) << rows.status();
  return rows.value_or(ReproduceRows());
}

TEST(ReproduceItems, FixedPointHasThePapersPlaceAndOneMultiplierThatIsAMisprint) {
  const ReproduceRows rows = Compute(FixedPointRows);
  ASSERT_EQ(rows.size(), 8U);
  // Figures of an independent prototype, good to 1e-10.
  const double expected[] = {3.650722922195, 0.669144118368, -0.384701258034,
                             0.9660613332,   -0.6647208898,  -1.3126468422};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(rows[i].values(0), expected[i], 2e-10) << i;
  for (int i = 0; i < 8; ++i) {
    const bool misprint = i == 3;
    EXPECT_EQ(rows[i].verdict() == v1::DIFFERS, misprint) << rows[i].ShortDebugString();
  }
}

TEST(ReproducePlan, RefusesAnotherSystemAndAnotherStone) {
  const BadSpecification table[] = {
      {"system { name: 'henon3d' } reproduce {}", "system: only celtic-stone", ""},
      {"system { parameters { key: 'delta' value: 0.4 } } reproduce {}",
       "delta: 0.4 is not allowed for reproduce", "0.485"},
  };
  for (const BadSpecification& bad : table) ExpectRefused(bad);
}

TEST(ReproducePlan, WritesPointsInThePapersFrameWhateverIsAskedFor) {
  EXPECT_EQ(Resolved("frame: FRAME_BODY reproduce {}").frame(), v1::FRAME_PAPER);
}

}  // namespace
}  // namespace celt::plans
