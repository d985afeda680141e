#include "core/integrate/sundials_flow.h"

#include <cmath>
#include <limits>
#include <string>

#include "gtest/gtest.h"

namespace celt {
namespace {

/// ẋ = y, ẏ = −x: turns the plane by −t.
class Rotation final : public Flow {
 public:
  int dimension() const override { return 2; }
  Point Field(const Point& x) const override { return Eigen::Vector2d(x[1], -x[0]); }
  SquareMatrix FieldJacobian(const Point&) const override {
    return Eigen::Matrix2d{{0, 1}, {-1, 0}};
  }
};

/// ẋ = x², which runs off to infinity at t = 1/x₀; not defined beyond `limit`.
class Explosion final : public Flow {
 public:
  explicit Explosion(double limit) : limit_(limit) {}
  int dimension() const override { return 1; }
  Point Field(const Point& x) const override { return x.cwiseProduct(x); }
  SquareMatrix FieldJacobian(const Point& x) const override { return 2 * x; }
  bool InDomain(const Point& x) const override { return std::abs(x[0]) <= limit_; }

 private:
  double limit_;
};

FlowPoint Start() { return {Eigen::Vector2d(3, 1), SquareMatrix::Identity(2, 2)}; }

class SundialsFlow : public testing::TestWithParam<Engine> {};

TEST_P(SundialsFlow, ErrorFollowsTheTolerance) {
  constexpr double kTime = 3;
  const Eigen::Matrix2d turn{{std::cos(kTime), std::sin(kTime)},
                             {-std::sin(kTime), std::cos(kTime)}};
  for (const double tolerance : {1e-5, 1e-8, 1e-11}) {
    const auto end = AdvanceFlow(Rotation(), Start(), kTime, {tolerance, GetParam()});
    ASSERT_TRUE(end.ok()) << end.status();
    // One to two hundred steps whose errors add up at worst, on vectors of size 3.
    EXPECT_LT((end->state - turn * Start().state).norm(), 1000 * tolerance);
    EXPECT_LT((end->tangents - turn).norm(), 1000 * tolerance);
  }
}

TEST_P(SundialsFlow, BackwardUndoesForward) {
  const auto there = AdvanceFlow(Rotation(), Start(), 2, {1e-12, GetParam()});
  ASSERT_TRUE(there.ok());
  const auto back = AdvanceFlow(Rotation(), *there, -2, {1e-12, GetParam()});
  ASSERT_TRUE(back.ok());
  EXPECT_LT((back->state - Start().state).norm(), 1e-9);
  EXPECT_LT((back->tangents - Start().tangents).norm(), 1e-9);
}

TEST_P(SundialsFlow, CarriesNoTangentsUnlessAsked) {
  const auto end =
      AdvanceFlow(Rotation(), {Start().state, SquareMatrix(2, 0)}, 1, {1e-10, GetParam()});
  ASSERT_TRUE(end.ok());
  EXPECT_EQ(end->tangents.cols(), 0);
}

void ExpectLostBeforeTheExplosion(double limit, Engine engine) {
  const FlowPoint start{Point::Constant(1, 2), SquareMatrix(1, 0)};
  const auto end = AdvanceFlow(Explosion(limit), start, 1, {1e-8, engine});
  ASSERT_EQ(end.status().code(), absl::StatusCode::kOutOfRange);
  const std::string message(end.status().message());
  // x = 1/(1/2 − t).
  EXPECT_TRUE(message.starts_with("orbit lost at t = 0.49") ||
              message.starts_with("orbit lost at t = 0.5,"))
      << message;
  EXPECT_NE(message.find("state ("), std::string::npos) << message;
}

TEST_P(SundialsFlow, SaysWhenAndWhereAnOrbitLeftTheDomain) {
  ExpectLostBeforeTheExplosion(/*limit=*/1e3, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Engines, SundialsFlow, testing::Values(Engine::kCvode, Engine::kArkode));

TEST(AdvanceFlow, RefusesStartsThatAreNone) {
  const FlowPoint no_number{Eigen::Vector2d(std::nan(""), 0), SquareMatrix(2, 0)};
  const FlowPoint too_short{Point::Constant(1, 1), SquareMatrix(2, 0)};
  for (const FlowPoint& start : {no_number, too_short}) {
    EXPECT_EQ(AdvanceFlow(Rotation(), start, 1, {}).status().code(),
              absl::StatusCode::kInvalidArgument);
  }
  const FlowPoint outside{Point::Constant(1, 5), SquareMatrix(1, 0)};
  EXPECT_EQ(AdvanceFlow(Explosion(4), outside, 1, {}).status().code(),
            absl::StatusCode::kInvalidArgument);
}

TEST(AdvanceFlow, RefusesAnEngineThatKnowsOnlyTheStone) {
  const auto end = AdvanceFlow(Rotation(), Start(), 1, {.engine = Engine::kFast});
  EXPECT_EQ(end.status().code(), absl::StatusCode::kInvalidArgument);
}

TEST(AdvanceFlow, SaysWhenAnOrbitRanOffToInfinity) {
  ExpectLostBeforeTheExplosion(std::numeric_limits<double>::infinity(), Engine::kDefault);
}

TEST(AdvanceFlow, ForNoTimeReturnsTheStart) {
  const auto end = AdvanceFlow(Rotation(), Start(), 0, {});
  ASSERT_TRUE(end.ok());
  EXPECT_EQ(end->state, Start().state);
}

}  // namespace
}  // namespace celt
