#include "core/analysis/separatrix.h"

#include <cmath>
#include <vector>

#include "core/map/celtic_stone_system.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

bool GoOn(std::int64_t) { return true; }

/// (u, v) → (a u − u³, v/2): 0 is a saddle for 1 < a. The separatrix tends to the fixed point
/// u² = a − 1 up to a = 2, where that doubles its period. The largest u of its attractor is
/// 2 (a/3)^(3/2), and its image is 0 at a = √(27/4): from there on the orbit changes sides.
class Cubic final : public Map {
 public:
  explicit Cubic(double a) : a_(a) {}
  int dimension() const override { return 2; }
  absl::StatusOr<Image> Apply(const Point& x, Direction, Derivative) const override {
    const double u = x[0];
    if (std::abs(u) > 3) return absl::OutOfRangeError("u is beyond 3");
    return Image{.point = Eigen::Vector2d(u * (a_ - u * u), x[1] / 2),
                 .time = 1,
                 .jacobian = Eigen::Matrix2d{{a_ - 3 * u * u, 0}, {0, 0.5}}};
  }

 private:
  double a_;
};

absl::StatusOr<std::unique_ptr<Map>> MakeCubic(double a) { return std::make_unique<Cubic>(a); }

SeparatrixFate FateAt(double a, int side) {
  const Cubic map(a);
  const auto saddle = MakeSaddle(map, {{Point::Zero(2)}}, Direction::kForward);
  SeparatrixOptions options;
  options.side = side;
  return FollowSeparatrix(map, *saddle, options, GoOn).value();
}

TEST(Separatrix, TendsToTheCycleOnItsSide) {
  for (const int side : {1, -1}) {
    const SeparatrixFate fate = FateAt(1.5, side);
    EXPECT_EQ(fate.end, SeparatrixEnd::kTendsToCycle);
    EXPECT_EQ(fate.side, side);
    EXPECT_EQ(fate.changes, 0);
    // Steps of the tolerance, 1e-6, at a multiplier of 3 − 2a = 0.
    EXPECT_NEAR(fate.point[0], side * std::sqrt(0.5), 1e-6);
  }
}

TEST(Separatrix, WandersWhenItChangesSidesTwice) {
  const SeparatrixFate fate = FateAt(2.8, 1);
  EXPECT_EQ(fate.end, SeparatrixEnd::kWanders);
  EXPECT_EQ(fate.changes, 2);
}

TEST(Separatrix, ChaosOnOneSideIsUndecided) {
  const SeparatrixFate fate = FateAt(2.5, 1);
  EXPECT_EQ(fate.end, SeparatrixEnd::kUndecided);
  EXPECT_EQ(fate.iterates, SeparatrixOptions().most_iterates);
  EXPECT_EQ(fate.changes, 0);
}

TEST(Separatrix, LostOrbitIsAFate) {
  const SeparatrixFate fate = FateAt(3.9, 1);
  EXPECT_EQ(fate.end, SeparatrixEnd::kLost);
  EXPECT_EQ(fate.message, "u is beyond 3");
}

SeparatrixSearch CubicSearch(double from, double to, double width, SeparatrixQuestion question) {
  return {.from = from,
          .to = to,
          .width = width,
          .guess = Point::Zero(2),
          .period = 1,
          .question = question,
          .options = {}};
}

TEST(Separatrix, BisectionFindsTheButterfly) {
  const auto bracket = BisectSeparatrix(
      MakeCubic, CubicSearch(2.5, 2.7, 1e-7, SeparatrixQuestion::kReturnsToItsSide), GoOn);
  ASSERT_TRUE(bracket.ok()) << bracket.status();
  EXPECT_LT(bracket->yes, bracket->no);
  EXPECT_LE(bracket->no - bracket->yes, 1e-7);
  // Beyond the switch by d a window of width about √d lets the orbit change sides: of 20000
  // iterates one meets it for d above some 1e-8.
  EXPECT_NEAR(bracket->yes, std::sqrt(27.0 / 4), 1e-6);
}

TEST(Separatrix, BisectionFindsWhereItLeavesTheCycle) {
  const auto bracket = BisectSeparatrix(
      MakeCubic, CubicSearch(1.5, 2.3, 1e-3, SeparatrixQuestion::kTendsToCycle), GoOn);
  ASSERT_TRUE(bracket.ok()) << bracket.status();
  // At 2 − d the multiplier is −1 + 2d: 20000 iterates are enough for d above some 1e-3.
  EXPECT_NEAR(bracket->yes, 2, 2e-3);
  EXPECT_EQ(bracket->yes_fate.end, SeparatrixEnd::kTendsToCycle);
  EXPECT_EQ(bracket->no_fate.end, SeparatrixEnd::kUndecided);
}

TEST(Separatrix, SameFateAtBothEndsIsRefusedWithBoth) {
  const auto bracket = BisectSeparatrix(
      MakeCubic, CubicSearch(1.3, 1.6, 1e-3, SeparatrixQuestion::kTendsToCycle), GoOn);
  EXPECT_EQ(bracket.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_NE(bracket.status().message().find("1.3 (tends to a cycle"), std::string::npos)
      << bracket.status();
}

TEST(Separatrix, BisectionLooksAtOneValueAtATime) {
  const SeparatrixSearch search =
      CubicSearch(2.5, 2.7, 1e-2, SeparatrixQuestion::kReturnsToItsSide);
  SeparatrixBisection bisection;
  std::vector<double> values;
  while (!bisection.done) {
    // As if it had been stored in between.
    SeparatrixBisection copy = bisection;
    ASSERT_TRUE(StepBisection(MakeCubic, search, copy, GoOn).ok());
    bisection = copy;
    values.push_back(bisection.last.value);
  }
  const std::vector<double> beginning = {2.5, 2.7, 2.6};
  ASSERT_GE(values.size(), 4);
  for (int i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(values[i], beginning[i]);
  const auto whole = BisectSeparatrix(MakeCubic, search, GoOn);
  const SeparatrixBracket bracket = BracketOf(bisection);
  EXPECT_EQ(bracket.yes, whole->yes);
  EXPECT_EQ(bracket.no, whole->no);
  EXPECT_EQ(bracket.yes_fate.iterates, whole->yes_fate.iterates);
}

TEST(Separatrix, EndsThatAgreeAreBothLookedAt) {
  const SeparatrixSearch search = CubicSearch(1.3, 1.6, 1e-3, SeparatrixQuestion::kTendsToCycle);
  SeparatrixBisection bisection;
  ASSERT_TRUE(StepBisection(MakeCubic, search, bisection, GoOn).ok());
  EXPECT_FALSE(StepBisection(MakeCubic, search, bisection, GoOn).ok());
  EXPECT_EQ(bisection.last.value, 1.6);
}

TEST(Separatrix, TickStopsTheSearch) {
  const auto bracket =
      BisectSeparatrix(MakeCubic, CubicSearch(1.5, 2.3, 1e-3, SeparatrixQuestion::kTendsToCycle),
                       [](std::int64_t n) { return n < 10; });
  EXPECT_EQ(bracket.status().code(), absl::StatusCode::kCancelled);
}

absl::StatusOr<std::unique_ptr<Map>> MakeStone(double energy) {
  return CelticStoneSystem().MakeMap({{"energy", energy}},
                                     {.tolerance = 1e-11, .engine = Engine::kFast});
}

/// The fixed point O* at E = 748.3 (tests/reference/celtic_stone.json).
const Point kSaddle = Eigen::Vector3d(2.143778784650, -0.661197341726, -0.374918922997);

TEST(StoneSeparatrix, HomoclinicButterflyIsAtItsReference) {
  const auto bracket = BisectSeparatrix(MakeStone,
                                        {.from = 748.439,
                                         .to = 748.440,
                                         .width = 2e-7,
                                         .guess = kSaddle,
                                         .period = 1,
                                         .question = SeparatrixQuestion::kReturnsToItsSide,
                                         .options = {.most_iterates = 3000, .tolerance = 1e-5}},
                                        GoOn);
  ASSERT_TRUE(bracket.ok()) << bracket.status();
  EXPECT_NEAR(bracket->yes, 748.4394655, 1e-6);
}

TEST(StoneSeparatrix, LeavesTheBasinOfTheCycleAtItsReference) {
  const auto bracket = BisectSeparatrix(MakeStone,
                                        {.from = 748.93,
                                         .to = 748.97,
                                         .width = 5e-4,
                                         .guess = kSaddle,
                                         .period = 1,
                                         .question = SeparatrixQuestion::kTendsToCycle,
                                         .options = {.most_iterates = 20000, .tolerance = 1e-5}},
                                        GoOn);
  ASSERT_TRUE(bracket.ok()) << bracket.status();
  EXPECT_NEAR(bracket->yes, 748.951, 2e-3);
}

}  // namespace
}  // namespace celt
