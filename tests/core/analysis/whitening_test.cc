#include "core/analysis/whitening.h"

#include <cmath>
#include <numbers>

#include "core/map/celtic_stone_system.h"
#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

TEST(Whitening, GivesItsPointsMeanZeroAndUnitCovariance) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  FramedOrbit orbit = {Henon3dSystem().DefaultStart(), SquareMatrix::Identity(3, 3)};
  CovarianceSums sums;
  std::vector<Point> points;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_TRUE(AdvanceCovariance(
                    **map, orbit, 1, [](std::int64_t) { return true; }, sums)
                    .ok());
    points.push_back(orbit.point);
  }
  const Whitening whitening = WhiteningOf(sums);
  CovarianceSums white;
  white.reference = Point::Zero(3);
  Point mean = Point::Zero(3);
  SquareMatrix covariance = SquareMatrix::Zero(3, 3);
  for (const Point& x : points) {
    const Point y = whitening.Apply(**map, x);
    mean += y / 2000;
    covariance += y * y.transpose() / 2000;
  }
  // Rounding of 2000 terms of order one, times the condition of C.
  EXPECT_LT(mean.norm(), 1e-12);
  EXPECT_LT((covariance - SquareMatrix::Identity(3, 3)).norm(), 1e-11);
  EXPECT_LT((whitening.matrix * whitening.inverse - SquareMatrix::Identity(3, 3)).norm(), 1e-13);
}

TEST(Whitening, KeepsNormalsNormal) {
  const Whitening whitening = {Point::Zero(3),
                               SquareMatrix(Eigen::Vector3d(1, 10, 100).asDiagonal()),
                               SquareMatrix(Eigen::Vector3d(1, 0.1, 0.01).asDiagonal())};
  const Point v = Eigen::Vector3d(1, 2, 3);
  const Point n = Eigen::Vector3d(3, 0, -1);
  ASSERT_EQ(v.dot(n), 0);
  EXPECT_NEAR(whitening.Direction(v).dot(whitening.Normal(n)), 0, 1e-15);
  EXPECT_NEAR(whitening.Direction(v).norm(), 1, 1e-15);
}

TEST(Whitening, MeasuresAnglesTheShortWayRound) {
  const auto map = CelticStoneSystem().MakeMap({}, {});
  CovarianceSums sums;
  AddPoint(**map, Eigen::Vector3d(0.1, 0, 0), sums);
  AddPoint(**map, Eigen::Vector3d(2 * std::numbers::pi - 0.1, 0, 0), sums);
  const Whitening whitening = WhiteningOf(sums);
  EXPECT_NEAR(std::sin(whitening.mean[0]), 0, 1e-15);
  EXPECT_NEAR(whitening.Apply(**map, Eigen::Vector3d(0.1, 0, 0))[0], 1, 1e-12);
}

TEST(Whitening, OfASinglePointIsTheIdentity) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  CovarianceSums sums;
  AddPoint(**map, Eigen::Vector3d(1, 2, 3), sums);
  EXPECT_EQ(WhiteningOf(sums).matrix, SquareMatrix(SquareMatrix::Identity(3, 3)));
}

}  // namespace
}  // namespace celt
