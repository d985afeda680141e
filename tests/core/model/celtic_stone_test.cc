#include "core/model/celtic_stone.h"

#include <cmath>
#include <limits>
#include <string>

#include "Eigen/Geometry"
#include "gtest/gtest.h"

namespace celt {
namespace {

/// States all over the place, on |γ| = 1 and with γ3 away from 0: no symmetry that could hide a
/// term.
StoneState SomeState(int i) {
  const double t = 1.0 + i;
  Eigen::Vector3d gamma(std::sin(1.3 * t), std::cos(2.1 * t), 1.1 + 0.9 * std::sin(0.7 * t));
  StoneState state;
  state << 40 * std::cos(t), 30 * std::sin(2 * t), -25 * std::cos(3 * t), gamma.normalized();
  return state;
}

constexpr int kStates = 20;
// A hundred or so roundings of terms that cancel.
constexpr double kRounding = 100 * std::numeric_limits<double>::epsilon();

TEST(CelticStone, FieldKeepsTheEnergy) {
  const CelticStone stone{StoneParameters{}};
  for (int i = 0; i < kStates; ++i) {
    const StoneState y = SomeState(i);
    const StoneState gradient = stone.EnergyGradient(y);
    const StoneState rate = stone.Field(y);
    EXPECT_NEAR(gradient.dot(rate), 0, kRounding * gradient.norm() * rate.norm());
  }
}

TEST(CelticStone, FieldKeepsTheVerticalAUnitVector) {
  const CelticStone stone{StoneParameters{}};
  for (int i = 0; i < kStates; ++i) {
    const StoneState y = SomeState(i);
    const Eigen::Vector3d rate = stone.Field(y).tail<3>();
    EXPECT_NEAR(y.tail<3>().dot(rate), 0, kRounding * rate.norm());
  }
}

TEST(CelticStone, MomentumIsThatOfTheRotationAboutTheContactPoint) {
  const CelticStone stone{StoneParameters{}};
  const StoneState y = SomeState(3);
  const Eigen::Vector3d r = stone.ContactPoint(y.tail<3>());
  const Eigen::Vector3d omega = stone.AngularVelocity(y);
  const Eigen::Vector3d momentum =
      stone.inertia() * omega + stone.parameters().mass * r.cross(omega.cross(r));
  EXPECT_LT((momentum - y.head<3>()).norm(), kRounding * y.head<3>().norm());
}

TEST(CelticStone, ContactPointLiesOnTheSurfaceWithTheVerticalAsItsNormal) {
  const StoneParameters p;
  const Eigen::Vector3d gamma = SomeState(5).tail<3>();
  const Eigen::Vector3d r = CelticStone{p}.ContactPoint(gamma);
  EXPECT_NEAR(r.x() * r.x() / p.radius1 + r.y() * r.y() / p.radius2, 2 * (r.z() + p.height),
              kRounding * r.squaredNorm());
  const Eigen::Vector3d normal(r.x() / p.radius1, r.y() / p.radius2, -1);
  EXPECT_LT(normal.cross(gamma).norm(), kRounding * normal.norm());
}

// Central differences with step h err by h² times a third derivative, and by rounding over h: about
// 1e-8 of the size with h = 1e-5 of the state's.
constexpr double kStep = 1e-5;
constexpr double kDifference = 1e-7;

TEST(CelticStone, FieldJacobianIsTheDerivativeOfTheField) {
  const CelticStone stone{StoneParameters{}};
  for (int i = 0; i < kStates; ++i) {
    const StoneState y = SomeState(i);
    const StoneMatrix jacobian = stone.FieldJacobian(y);
    for (int j = 0; j < 6; ++j) {
      StoneState h = StoneState::Zero();
      h[j] = kStep;
      const StoneState difference = (stone.Field(y + h) - stone.Field(y - h)) / (2 * kStep);
      EXPECT_LT((jacobian.col(j) - difference).norm(), kDifference * jacobian.norm())
          << i << ' ' << j;
    }
  }
}

TEST(CelticStone, EnergyGradientIsTheDerivativeOfTheEnergy) {
  const CelticStone stone{StoneParameters{}};
  for (int i = 0; i < kStates; ++i) {
    const StoneState y = SomeState(i);
    const StoneState gradient = stone.EnergyGradient(y);
    for (int j = 0; j < 6; ++j) {
      StoneState h = StoneState::Zero();
      h[j] = kStep;
      const double difference = (stone.Energy(y + h) - stone.Energy(y - h)) / (2 * kStep);
      EXPECT_NEAR(gradient[j], difference, kDifference * gradient.norm()) << i << ' ' << j;
    }
  }
}

TEST(CelticStone, AtRestUprightItHasTheEnergyOfItsHeight) {
  const StoneParameters p;
  StoneState upright = StoneState::Zero();
  upright[5] = 1;
  EXPECT_DOUBLE_EQ(CelticStone{p}.Energy(upright), p.mass * p.gravity * p.height);
  EXPECT_EQ(CelticStone{p}.Field(upright).norm(), 0);
}

std::string Refusal(double StoneParameters::*field, double value) {
  StoneParameters p;
  p.*field = value;
  const absl::Status status = CheckStone(p);
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  return std::string(status.message());
}

TEST(CheckStone, AcceptsThePapersStone) { EXPECT_TRUE(CheckStone(StoneParameters{}).ok()); }

TEST(CheckStone, NamesTheParameterItsValueAndWhatIsAllowed) {
  EXPECT_EQ(Refusal(&StoneParameters::mass, -1), "mass: -1 is not allowed; must be positive");
  EXPECT_EQ(Refusal(&StoneParameters::height, 0), "height: 0 is not allowed; must be positive");
  EXPECT_EQ(Refusal(&StoneParameters::delta, std::nan("")),
            "delta: nan is not allowed; must be finite");
  EXPECT_EQ(Refusal(&StoneParameters::inertia3, 8.5),
            "inertia_3: 8.5 is not allowed; of a body it is at most the sum of the other two, 8");
}

TEST(CheckStone, RefusesAnythingNotFinite) {
  for (double StoneParameters::*field :
       {&StoneParameters::inertia1, &StoneParameters::inertia2, &StoneParameters::inertia3,
        &StoneParameters::mass, &StoneParameters::gravity, &StoneParameters::radius1,
        &StoneParameters::radius2, &StoneParameters::height, &StoneParameters::delta}) {
    for (double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
      EXPECT_FALSE(Refusal(field, value).empty());
    }
  }
}

}  // namespace
}  // namespace celt
