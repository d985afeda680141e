#include "core/model/rolling.h"

#include <cmath>

#include "Eigen/Geometry"
#include "gtest/gtest.h"

namespace celt {
namespace {

const CelticStone kStone{StoneParameters{}};

StoneState SomeState() {
  StoneState state;
  state << 30, -20, 50, Eigen::Vector3d(0.3, -0.2, 0.9).normalized();
  return state;
}

TEST(Rolling, ContactVelocityIsTheRateOfTheContactPoint) {
  const StoneState state = SomeState();
  const Eigen::Vector3d gamma = state.tail<3>();
  const Eigen::Vector3d rate = kStone.Field(state).tail<3>();
  const double h = 1e-6;
  const Eigen::Vector3d difference =
      (kStone.ContactPoint(gamma + h * rate) - kStone.ContactPoint(gamma - h * rate)) / (2 * h);
  // Central differences: h² and rounding/h, relative to a velocity of about 30.
  EXPECT_LT((ContactVelocity(kStone, state) - difference).norm(), 1e-7);
}

TEST(Rolling, ContactMovesInThePlane) {
  const StoneState state = SomeState();
  EXPECT_NEAR(ContactVelocity(kStone, state).dot(state.tail<3>()), 0, 1e-13);
}

TEST(Rolling, AttitudeStaysARotation) {
  const RollingState state = PlaceAtOrigin(SomeState());
  const Eigen::Vector3d gamma = state.stone.tail<3>();
  EXPECT_NEAR(state.heading.norm(), 1, 1e-15);
  EXPECT_NEAR(state.heading.dot(gamma), 0, 1e-15);
  const RollingState rate = RollingRate(kStone, state);
  EXPECT_NEAR(rate.heading.dot(state.heading), 0, 1e-12);
  EXPECT_NEAR(rate.heading.dot(gamma) + state.heading.dot(rate.stone.tail<3>()), 0, 1e-12);
}

TEST(Rolling, SpinIsTheVerticalPartOfTheRotation) {
  StoneState state;
  state << kStone.ContactInertia(Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(0, 0, 3), 0, 0, 1;
  EXPECT_NEAR(RollingRate(kStone, PlaceAtOrigin(state)).spin, 3, 1e-14);
}

}  // namespace
}  // namespace celt
