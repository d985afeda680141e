#include "core/map/lorenz_system.h"

#include <cmath>

#include "Eigen/LU"
#include "gtest/gtest.h"

namespace celt {
namespace {

const Point kX = Eigen::Vector3d(1.5, -2, 22);

absl::StatusOr<Image> Sample(const Point& x, double step, Direction direction) {
  const auto map = LorenzSystem().MakeMap({{"step", step}}, {.tolerance = 1e-12});
  if (!map.ok()) return map.status();
  return (*map)->Apply(x, direction, Derivative::kJacobian);
}

TEST(Lorenz, SamplesCompose) {
  const auto half = Sample(kX, 0.25, Direction::kForward);
  ASSERT_TRUE(half.ok());
  const auto twice = Sample(half->point, 0.25, Direction::kForward);
  const auto whole = Sample(kX, 0.5, Direction::kForward);
  ASSERT_TRUE(twice.ok() && whole.ok());
  // Tolerance 1e-12 a step of numbers of size 30, some 30 steps, stretched at most tenfold.
  EXPECT_LT((twice->point - whole->point).norm(), 1e-8);
  EXPECT_LT((twice->jacobian * half->jacobian - whole->jacobian).norm(), 1e-8);
  EXPECT_EQ(whole->time, 0.5);
}

TEST(Lorenz, VolumeContractsAtTheDivergence) {
  const auto image = Sample(kX, 0.5, Direction::kForward);
  ASSERT_TRUE(image.ok());
  EXPECT_NEAR(std::log(image->jacobian.determinant()), -0.5 * (10 + 1 + 8.0 / 3), 1e-8);
}

TEST(Lorenz, BackwardUndoesForward) {
  const auto there = Sample(kX, 0.1, Direction::kForward);
  ASSERT_TRUE(there.ok());
  const auto back = Sample(there->point, 0.1, Direction::kBackward);
  ASSERT_TRUE(back.ok());
  EXPECT_LT((back->point - kX).norm(), 1e-8);
  EXPECT_EQ(back->time, 0.1);
}

TEST(Lorenz, EquilibriumStaysWhereItIs) {
  const double c = std::sqrt(8.0 / 3 * 27);
  const Point equilibrium = Eigen::Vector3d(c, c, 27);
  const auto image = Sample(equilibrium, 0.5, Direction::kForward);
  ASSERT_TRUE(image.ok());
  EXPECT_LT((image->point - equilibrium).norm(), 1e-10);
}

}  // namespace
}  // namespace celt
