#include "core/analysis/accuracy.h"

#include <cmath>
#include <utility>

#include "core/map/celtic_stone_system.h"
#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"
#include "tests/core/reference.h"

namespace celt {
namespace {

std::unique_ptr<Map> Stone(double tolerance, Engine engine = Engine::kFast) {
  auto map = CelticStoneSystem().MakeMap({}, {.tolerance = tolerance, .engine = engine});
  EXPECT_TRUE(map.ok()) << map.status();
  return *std::move(map);
}

std::vector<Point> Attractor() {
  std::vector<Point> points;
  for (const ReferenceIterate& iterate : ReferenceIterates()) points.push_back(iterate.point);
  return points;
}

/// x → A x, with a drift to report.
class LinearMap final : public Map {
 public:
  explicit LinearMap(SquareMatrix a, double drift = 0) : a_(std::move(a)), drift_(drift) {}
  int dimension() const override { return static_cast<int>(a_.rows()); }
  absl::StatusOr<Image> Apply(const Point& x, Direction, Derivative) const override {
    if (x[0] > 100) return absl::OutOfRangeError("lost");
    return Image{.point = a_ * x, .time = 1, .jacobian = a_, .drift = drift_};
  }

 private:
  SquareMatrix a_;
  double drift_;
};

TEST(CompareMaps, FindsTheErrorThatTheReferenceFinds) {
  for (const double tolerance : {1e-9, 1e-11}) {
    const auto map = Stone(tolerance);
    double map_error = 0;
    double jacobian_error = 0;
    for (const ReferenceIterate& iterate : ReferenceIterates()) {
      const auto image = map->Apply(iterate.point, Direction::kForward, Derivative::kJacobian);
      ASSERT_TRUE(image.ok());
      map_error =
          std::max(map_error, map->Difference(image->point, iterate.image).cwiseAbs().maxCoeff());
      jacobian_error =
          std::max(jacobian_error, (image->jacobian - iterate.jacobian).cwiseAbs().maxCoeff() /
                                       iterate.jacobian.cwiseAbs().maxCoeff());
    }
    const auto measured = CompareMaps(*map, *Stone(tolerance / 100), Attractor());
    ASSERT_TRUE(measured.ok()) << measured.status();
    EXPECT_EQ(measured->sample, 200);
    // The map at a hundredth of the tolerance errs by a hundredth, or a little more.
    EXPECT_NEAR(measured->map_error, map_error, 0.05 * map_error);
    EXPECT_NEAR(measured->jacobian_error, jacobian_error, 0.05 * jacobian_error);
  }
}

TEST(CompareMaps, DriftFollowsTheTolerance) {
  const auto drift = [](double tolerance) {
    const auto accuracy = CompareMaps(*Stone(tolerance), *Stone(1e-13), Attractor());
    EXPECT_TRUE(accuracy.ok());
    return accuracy->drift;
  };
  // The ninth order: a hundredth of the tolerance, a hundredth of the drift.
  EXPECT_GT(drift(1e-9), 30 * drift(1e-11));
  EXPECT_LT(drift(1e-9), 1e-7);
  EXPECT_GT(drift(1e-9), 1e-10);
}

TEST(CompareMaps, FindsNothingInAFormula) {
  const auto map = Henon3dSystem().MakeMap({}, {.tolerance = 1e-3});
  const auto better = Henon3dSystem().MakeMap({}, {.tolerance = 1e-14});
  const std::vector<Point> sample = {Eigen::Vector3d(0.1, 0.2, 0.3)};
  const auto accuracy = CompareMaps(**map, **better, sample);
  ASSERT_TRUE(accuracy.ok());
  EXPECT_EQ(accuracy->sample, 1);
  EXPECT_EQ(accuracy->map_error, 0);
  EXPECT_EQ(accuracy->jacobian_error, 0);
  EXPECT_EQ(accuracy->drift, 0);
}

TEST(CompareMaps, LeavesOutPointsThatAreLost) {
  const LinearMap map(Eigen::Matrix2d{{2, 0}, {0, 0.5}}, 1e-5);
  const LinearMap better(Eigen::Matrix2d{{2.25, 0}, {0, 0.5}});
  const std::vector<Point> sample = {Eigen::Vector2d(1000, 1), Eigen::Vector2d(1, 1)};
  const auto accuracy = CompareMaps(map, better, sample);
  ASSERT_TRUE(accuracy.ok());
  EXPECT_EQ(accuracy->sample, 1);
  EXPECT_EQ(accuracy->map_error, 0.25);
  EXPECT_EQ(accuracy->jacobian_error, 0.25 / 2.25);
  EXPECT_EQ(accuracy->drift, 1e-5);
}

TEST(ExponentErrors, AreDifferencesOfTheLogarithms) {
  const LinearMap map(Eigen::Matrix2d{{2, 0}, {0, 0.5}});
  const LinearMap better(Eigen::Matrix2d{{2.02, 0}, {0, 0.5}});
  const FramedOrbit orbit{.point = Eigen::Vector2d(1, 1), .frame = Eigen::Matrix2d::Identity()};
  const FramedOrbit lost{.point = Eigen::Vector2d(1000, 1), .frame = orbit.frame};
  const auto errors = ExponentErrors(map, better, std::vector{orbit, lost, orbit});
  ASSERT_TRUE(errors.ok());
  EXPECT_NEAR(errors->at(0), std::log(1.01), 1e-15);
  EXPECT_EQ(errors->at(1), 0);
  EXPECT_EQ(ExponentErrors(map, better, std::vector{lost})->at(0), 0);
}

TEST(ExponentErrors, AreOfTheOrderOfTheJacobiansForTheStone) {
  std::vector<FramedOrbit> sample;
  for (const Point& point : Attractor())
    sample.push_back({.point = point, .frame = Eigen::Matrix3d::Identity()});
  const auto errors = ExponentErrors(*Stone(1e-9), *Stone(1e-11), sample);
  ASSERT_TRUE(errors.ok());
  for (const double error : *errors) {
    EXPECT_GT(error, 0);
    // The Jacobian errs by 30 tolerances, relative to an entry some 50 times its determinant's
    // root.
    EXPECT_LT(error, 1e-9 * 30 * 50);
  }
}

}  // namespace
}  // namespace celt
