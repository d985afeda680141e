#include "core/model/andoyer.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "gtest/gtest.h"

namespace celt {
namespace {

constexpr double kEnergy = 752;
constexpr double kPi = std::numbers::pi;
// A few dozen roundings of numbers of size one, or of the momentum's size.
constexpr double kRounding = 100 * std::numeric_limits<double>::epsilon();

CelticStone Stone() { return CelticStone{StoneParameters{}}; }

/// Points in all octants, on two sections, where the level is not empty and |γ₃| not small: towards
/// γ₃ = 0 rounding and derivatives are magnified without bound, and no tolerance would mean
/// anything.
struct Case {
  SectionPoint x;
  double angle;
};

std::vector<Case> Cases() {
  std::vector<Case> cases;
  for (const double angle : {kPi, 0.7}) {
    for (int i = 0; i < 60; ++i) {
      const SectionPoint x(std::fmod(0.37 + 1.1 * i, 2 * kPi), 0.9 * std::sin(1.7 * i),
                           0.8 * std::cos(2.3 * i));
      const auto lifted = LiftToLevel(Stone(), kEnergy, angle, x);
      if (lifted.ok() && std::abs(lifted->state[5]) > 0.25) cases.push_back({x, angle});
    }
  }
  return cases;
}

TEST(Andoyer, VariablesAndStateAreInverseToEachOther) {
  const Andoyer a{.L = -12, .H = 9, .G = 30, .l = 5.1, .g = 2.2};
  const StoneState state = FromAndoyer(a);
  EXPECT_NEAR(state.tail<3>().norm(), 1, kRounding);
  const Andoyer back = ToAndoyer(state);
  EXPECT_NEAR(back.L, a.L, kRounding * a.G);
  EXPECT_NEAR(back.H, a.H, kRounding * a.G);
  EXPECT_NEAR(back.G, a.G, kRounding * a.G);
  EXPECT_NEAR(back.l, a.l, kRounding);
  EXPECT_NEAR(back.g, a.g, kRounding);
}

TEST(Andoyer, AnglesFollowThePapersSigns) {
  StoneState state;
  state << 3, 4, 5, 0.6, 0, 0.8;
  const Andoyer a = ToAndoyer(state);
  EXPECT_DOUBLE_EQ(std::tan(a.l), 3.0 / 4);
  EXPECT_GT(std::sin(a.g), 0);  // M₂γ₁ − M₁γ₂ = 2.4
  EXPECT_LT(std::cos(a.g), 0);  // LH − G²γ₃ = 5·5.8 − 50·0.8
}

TEST(LiftToLevel, PutsTheStateOnTheLevelAndOnTheSection) {
  ASSERT_GT(Cases().size(), 40u);
  for (const Case& c : Cases()) {
    const LiftedPoint lifted = *LiftToLevel(Stone(), kEnergy, c.angle, c.x);
    EXPECT_NEAR(Stone().Energy(lifted.state), kEnergy, kRounding * kEnergy);
    EXPECT_NEAR(lifted.state.tail<3>().norm(), 1, kRounding);
    EXPECT_NEAR(ToAndoyer(lifted.state).g, c.angle, kRounding);
  }
}

TEST(LiftToLevel, IsUndoneByTheProjectionWithItsDerivative) {
  for (const Case& c : Cases()) {
    const LiftedPoint lifted = *LiftToLevel(Stone(), kEnergy, c.angle, c.x);
    const ProjectedState projected = ProjectToSection(lifted.state);
    EXPECT_LT((projected.x - c.x).norm(), kRounding);
    // Rounding is magnified by the derivatives, of which the lift's is by far the larger.
    EXPECT_LT((projected.derivative * lifted.derivative - Eigen::Matrix3d::Identity()).norm(),
              kRounding * lifted.derivative.norm());
  }
}

// Central differences with step h = 1e-5 err by h² times a third derivative and by rounding over h.
constexpr double kStep = 1e-5;
constexpr double kDifference = 1e-7;

TEST(LiftToLevel, DerivativeIsThatOfTheLift) {
  for (const Case& c : Cases()) {
    if (std::abs(c.x[1]) > 0.85)
      continue;  // third derivatives grow without bound towards |L/G| = 1
    const LiftedPoint lifted = *LiftToLevel(Stone(), kEnergy, c.angle, c.x);
    for (int j = 0; j < 3; ++j) {
      const SectionPoint h = kStep * SectionPoint::Unit(j);
      const auto ahead = LiftToLevel(Stone(), kEnergy, c.angle, c.x + h);
      const auto behind = LiftToLevel(Stone(), kEnergy, c.angle, c.x - h);
      ASSERT_TRUE(ahead.ok() && behind.ok());
      const StoneState difference = (ahead->state - behind->state) / (2 * kStep);
      EXPECT_LT((lifted.derivative.col(j) - difference).norm(),
                kDifference * lifted.derivative.norm())
          << c.x.transpose() << " column " << j;
    }
  }
}

TEST(ProjectToSection, DerivativeIsThatOfTheProjection) {
  StoneState state;
  state << 11, -17, 8, 0.3, -0.5, std::sqrt(1 - 0.34);
  const ProjectedState projected = ProjectToSection(state);
  for (int j = 0; j < 6; ++j) {
    const StoneState h = kStep * StoneState::Unit(j);
    const SectionPoint difference =
        (ProjectToSection(state + h).x - ProjectToSection(state - h).x) / (2 * kStep);
    EXPECT_LT((projected.derivative.col(j) - difference).norm(), kDifference);
  }
}

std::string Refusal(double energy, const SectionPoint& x) {
  const auto lifted = LiftToLevel(Stone(), energy, kPi, x);
  EXPECT_EQ(lifted.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(lifted.status().message());
}

TEST(LiftToLevel, RefusesWhatIsNoPointOfTheSection) {
  EXPECT_EQ(Refusal(kEnergy, {1, 1, 0.2}), "l_over_g: 1 is not allowed; must lie in (-1, 1)");
  EXPECT_EQ(Refusal(kEnergy, {1, 0.2, -1.5}), "h_over_g: -1.5 is not allowed; must lie in (-1, 1)");
  EXPECT_EQ(Refusal(kEnergy, {1, std::nan(""), 0}),
            "l_over_g: nan is not allowed; must lie in (-1, 1)");
  EXPECT_EQ(Refusal(kEnergy, {std::numeric_limits<double>::infinity(), 0, 0}),
            "l: inf is not allowed; must be finite");
}

TEST(LiftToLevel, SaysTheLeastEnergyWhereTheLevelIsEmpty) {
  // At L/G = H/G = 0 and g = π the stone stands upright: the potential energy is m g h.
  EXPECT_EQ(Refusal(99, {1, 0, 0}),
            "energy: 99 is not allowed at l = 1, l_over_g = 0, h_over_g = 0; must be finite and "
            "above the "
            "potential energy there, 100");
  EXPECT_NE(Refusal(std::nan(""), {1, 0, 0}).find("energy: nan"), std::string::npos);
  EXPECT_NE(Refusal(1e308, {1, 0, 0}).find("too large"), std::string::npos);
}

TEST(LiftToLevel, RefusesAVerticalInTheHorizontalPlaneOfTheBody) {
  // γ₃ = pq + √(1−p²)√(1−q²) = 0 at g = π where p² + q² = 1 and pq < 0.
  EXPECT_EQ(Refusal(kEnergy, {1, 0.6, -0.8}).find("start: gamma3 = "), 0u);
}

TEST(ExchangeFrame, IsItsOwnInverse) {
  const SectionPoint x(2.1, -0.6, -0.4);
  const double delta = 0.485;
  EXPECT_LT((ExchangeFrame(ExchangeFrame(x, delta), delta) - x).norm(), kRounding);
}

TEST(ExchangeFrame, TakesThePapersPointToWhereThePaperPrintsIt) {
  const SectionPoint paper =
      ExchangeFrame({2.147462384985, -0.669144118368, -0.384701258034}, 0.485);
  // The paper prints three decimals, cut off rather than rounded.
  EXPECT_LT((paper - SectionPoint(3.650, 0.669, -0.384)).cwiseAbs().maxCoeff(), 1e-3);
}

}  // namespace
}  // namespace celt
