#include "core/analysis/cycle_type.h"

#include <string>
#include <vector>

#include "gtest/gtest.h"

namespace celt {
namespace {

std::string NameFor(const std::vector<Multiplier>& multipliers) { return TypeOf(multipliers).name; }

TEST(CycleType, GivesTheUsualNames) {
  EXPECT_EQ(NameFor({0.9, -0.5, 0.1}), "stable node");
  EXPECT_EQ(NameFor({{0.5, 0.5}, {0.5, -0.5}, 0.1}), "stable focus");
  EXPECT_EQ(NameFor({-3, 2, 1.5}), "unstable node");
  EXPECT_EQ(NameFor({{2, 1}, {2, -1}, 1.1}), "unstable focus");
  EXPECT_EQ(NameFor({-1.3, 0.97, -0.66}), "saddle 2-1");
  EXPECT_EQ(NameFor({{1, 1}, {1, -1}, 0.2}), "saddle-focus 1-2");
  EXPECT_EQ(NameFor({-2, {0.3, 0.3}, {0.3, -0.3}}), "saddle-focus 2-1");
  EXPECT_EQ(NameFor({{0.6, 0.8}, {0.6, -0.8}, 0.2}), "non-hyperbolic 1-0");
}

TEST(CycleType, CountsDimensionsAndSides) {
  const CycleType type = TypeOf(std::vector<Multiplier>{-1.3, {0.3, 0.2}, {0.3, -0.2}, 0.1});
  EXPECT_EQ(type.stable, 3);
  EXPECT_EQ(type.unstable, 1);
  EXPECT_EQ(type.neutral, 0);
  EXPECT_EQ(type.sides, (std::vector<int>{-1, 0, 0, 1}));
}

TEST(CycleType, ToleranceSaysWhatIsOnTheCircle) {
  const std::vector<Multiplier> multipliers = {-1.001, 0.5};
  EXPECT_EQ(TypeOf(multipliers, 1e-2).kind, CycleKind::kNonHyperbolic);
  EXPECT_EQ(TypeOf(multipliers, 1e-4).kind, CycleKind::kSaddle);
}

/// The multipliers of O* at E = 752 (tests/reference/celtic_stone.json).
TEST(LorenzConditions, HoldForTheStonesFixedPointWithTheirMargins) {
  const auto conditions =
      LorenzConditions(std::vector<Multiplier>{-1.3126468422, 0.9660613332, -0.6647208898});
  ASSERT_EQ(conditions.size(), 8);
  for (const CycleCondition& condition : conditions) EXPECT_TRUE(condition.holds) << condition.name;
  EXPECT_DOUBLE_EQ(conditions[1].margin, 0.9660613332 - 0.6647208898);
  EXPECT_DOUBLE_EQ(conditions[6].margin, 0.3126468422);
  EXPECT_DOUBLE_EQ(conditions[7].margin, 0.9660613332 * 1.3126468422 - 1);
}

TEST(LorenzConditions, EachFailsWhereItIsViolated) {
  struct Violation {
    std::vector<Multiplier> multipliers;
    std::vector<std::string> failing;
  };
  const std::vector<Violation> violations = {
      {{1.3, 0.97, -0.66}, {"gamma < -1"}},
      {{-1.3, -0.97, -0.66}, {"lambda1 > 0"}},
      {{-1.3, 0.97, 0.66}, {"lambda2 < 0"}},
      {{-1.3, 0.7, -0.66}, {"|lambda1 gamma| > 1"}},
      {{-1.3, 1.1, -0.66}, {"|lambda1| < 1"}},
      {{-1.3, {0.9, 0.1}, {0.9, -0.1}},
       {"real multipliers", "|lambda2| < |lambda1|", "lambda2 < 0"}},
  };
  for (const Violation& violation : violations) {
    std::vector<std::string> failing;
    for (const CycleCondition& condition : LorenzConditions(violation.multipliers)) {
      if (!condition.holds) failing.emplace_back(condition.name);
    }
    EXPECT_EQ(failing, violation.failing);
  }
}

TEST(LorenzConditions, SpeakOfThreeDimensions) {
  EXPECT_TRUE(LorenzConditions(std::vector<Multiplier>{-1.3, 0.9}).empty());
}

}  // namespace
}  // namespace celt
