#include "core/map/henon3d_system.h"

#include "Eigen/LU"
#include "gtest/gtest.h"

namespace celt {
namespace {

const Parameters kGeneral = {{"m1", 0.1}, {"m2", 0.8}, {"a", -0.2}, {"b", 0.6}};
const Parameters kQuadratic = {{"m1", 0.1}, {"m2", 0.8},  {"a", -0.2}, {"b", 0.6},
                               {"yy", 0.3}, {"yz", -0.7}, {"zz", 0.9}};
const Point kX = Eigen::Vector3d(0.3, -0.2, 0.5);

TEST(Henon3d, FollowsItsFormula) {
  const auto map = Henon3dSystem().MakeMap(kGeneral, {});
  ASSERT_TRUE(map.ok());
  const auto image = (*map)->Apply(kX, Direction::kForward, Derivative::kNone);
  ASSERT_TRUE(image.ok());
  EXPECT_EQ(image->point[0], -0.2);
  EXPECT_EQ(image->point[1], 0.5);
  EXPECT_DOUBLE_EQ(image->point[2], 0.1 + 0.6 * 0.3 + 0.8 * -0.2 - 0.2 * 0.5 - 0.25);
  EXPECT_EQ(image->jacobian.size(), 0);
}

TEST(Henon3d, TakesEveryQuadraticTermOfYAndZ) {
  const auto map = Henon3dSystem().MakeMap(kQuadratic, {});
  const auto image = (*map)->Apply(kX, Direction::kForward, Derivative::kNone);
  EXPECT_DOUBLE_EQ(image->point[2], 0.1 + 0.6 * 0.3 + 0.8 * -0.2 - 0.2 * 0.5 + 0.3 * 0.2 * 0.2 -
                                        0.7 * -0.2 * 0.5 + 0.9 * 0.5 * 0.5);
}

TEST(Henon3d, DefaultIsTheClassicalMapToTheLastBit) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  Point x = Eigen::Vector3d(0.1, 0.1, 0.1);
  for (int i = 0; i < 1000; ++i) {
    const auto image = (*map)->Apply(x, Direction::kForward, Derivative::kNone);
    ASSERT_EQ(image->point[2], 0 + 0.7 * x[0] + 0.85 * x[1] + 0 * x[2] - x[2] * x[2]);
    x = image->point;
  }
}

TEST(Henon3d, InverseUndoesTheMapAndItsJacobian) {
  const auto map = Henon3dSystem().MakeMap(kQuadratic, {});
  ASSERT_TRUE(map.ok());
  const auto there = (*map)->Apply(kX, Direction::kForward, Derivative::kJacobian);
  ASSERT_TRUE(there.ok());
  const auto back = (*map)->Apply(there->point, Direction::kBackward, Derivative::kJacobian);
  ASSERT_TRUE(back.ok());
  // Rounding of a handful of operations on numbers below one, divided by b.
  EXPECT_LT((back->point - kX).norm(), 1e-15);
  EXPECT_LT((back->jacobian * there->jacobian - SquareMatrix::Identity(3, 3)).norm(), 1e-14);
}

TEST(Henon3d, JacobianIsTheDerivative) {
  const auto map = Henon3dSystem().MakeMap(kQuadratic, {});
  ASSERT_TRUE(map.ok());
  const auto image = (*map)->Apply(kX, Direction::kForward, Derivative::kJacobian);
  ASSERT_TRUE(image.ok());
  EXPECT_DOUBLE_EQ(image->jacobian.determinant(), 0.6);
  constexpr double kStep = 1e-5;
  for (int j = 0; j < 3; ++j) {
    const Point step = kStep * Point::Unit(3, j);
    const auto plus = (*map)->Apply(kX + step, Direction::kForward, Derivative::kNone);
    const auto minus = (*map)->Apply(kX - step, Direction::kForward, Derivative::kNone);
    const Point difference = (plus->point - minus->point) / (2 * kStep);
    // Central differences of a quadratic are exact: rounding over the step.
    EXPECT_LT((difference - image->jacobian.col(j)).norm(), 1e-10);
  }
}

TEST(Henon3d, EscapeIsAStatus) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  ASSERT_TRUE(map.ok());
  const auto image =
      (*map)->Apply(Eigen::Vector3d(1, 1, 2e3), Direction::kForward, Derivative::kNone);
  EXPECT_EQ(image.status().code(), absl::StatusCode::kOutOfRange);
}

TEST(Henon3d, SingularMapHasNoInverse) {
  const auto map = Henon3dSystem().MakeMap({{"b", 0}}, {});
  ASSERT_TRUE(map.ok());
  const auto image = (*map)->Apply(kX, Direction::kBackward, Derivative::kNone);
  EXPECT_EQ(image.status().code(), absl::StatusCode::kUnimplemented);
}

}  // namespace
}  // namespace celt
