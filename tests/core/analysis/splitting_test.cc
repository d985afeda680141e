#include "core/analysis/splitting.h"

#include <cmath>

#include "core/analysis/line_angle.h"
#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

bool GoOn(std::int64_t) { return true; }

/// x → A x on a single point.
class LinearMap final : public Map {
 public:
  explicit LinearMap(SquareMatrix a) : a_(std::move(a)) {}
  int dimension() const override { return static_cast<int>(a_.rows()); }
  absl::StatusOr<Image> Apply(const Point& x, Direction, Derivative) const override {
    return Image{.point = x, .time = 1, .jacobian = a_};
  }

 private:
  SquareMatrix a_;
};

FramedOrbit HenonStart(const Map& map) {
  std::vector<FramedOrbit> orbits =
      DrawStarts(Henon3dSystem().DefaultStart(), Point::Zero(3), 1, 1);
  EXPECT_TRUE(AdvanceFrames(map, orbits, 1000, GoOn).ok());
  return orbits.front();
}

TEST(Splitting, OfALinearMapIsThatOfItsEigenvectors) {
  // Eigenvectors (1, 0, 0), (0, 1, 0), (1, 1, 2) of 3, 0.9, 0.1.
  const SquareMatrix v = Eigen::Matrix3d{{1, 0, 1}, {0, 1, 1}, {0, 0, 2}};
  const SquareMatrix inverse = Eigen::Matrix3d{{1, 0, -0.5}, {0, 1, -0.5}, {0, 0, 0.5}};
  const Point lambda = Eigen::Vector3d(3, 0.9, 0.1);
  const LinearMap map(v * lambda.asDiagonal() * inverse);
  std::vector<FramedOrbit> orbits = DrawStarts(Point::Zero(3), Point::Zero(3), 1, 1);
  ASSERT_TRUE(AdvanceFrames(map, orbits, 100, GoOn).ok());
  SplittingOrbit orbit = {.orbit = orbits.front(), .iterates = 0, .pending = {}};
  const auto stretch = AdvanceSplitting(map, orbit, 100, 50, GoOn);
  ASSERT_TRUE(stretch.ok()) << stretch.status();
  ASSERT_EQ(stretch->samples.size(), 50U);
  // Both transients have fallen by 9^50: what is left is rounding.
  for (const SplittingSample& sample : stretch->samples) {
    EXPECT_LT(AngleOfLines(sample.stable, v.col(2).normalized()), 1e-14);
    EXPECT_LT(AngleOfLines(sample.cu_normal, Eigen::Vector3d(0, 0, 1)), 1e-14);
    EXPECT_NEAR(sample.log_volume, std::log(3 * 0.9), 1e-14);
  }
  EXPECT_LT(stretch->disagreement, 1e-14);
  const Whitening none = {Point::Zero(3), SquareMatrix::Identity(3, 3),
                          SquareMatrix::Identity(3, 3)};
  EXPECT_NEAR(SplittingAngle(none, stretch->samples[0]), std::asin(2 / std::sqrt(6)), 1e-14);
}

TEST(Splitting, IsInvariantUnderTheMap) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  SplittingOrbit orbit = {.orbit = HenonStart(**map), .iterates = 0, .pending = {}};
  const auto stretch = AdvanceSplitting(**map, orbit, 400, 200, GoOn);
  ASSERT_TRUE(stretch.ok());
  for (std::size_t i = 0; i + 1 < stretch->samples.size(); ++i) {
    const auto image =
        (*map)->Apply(stretch->samples[i].point, Direction::kForward, Derivative::kJacobian);
    const Point pushed = (image->jacobian * stretch->samples[i].stable).normalized();
    // Pulling back and pushing forward by a matrix of condition about 10.
    EXPECT_LT(AngleOfLines(pushed, stretch->samples[i + 1].stable), 1e-13);
  }
}

TEST(Splitting, StretchesGiveEverySampleOnceAndTheSame) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  SplittingOrbit whole = {.orbit = HenonStart(**map), .iterates = 0, .pending = {}};
  SplittingOrbit cut = whole;
  const auto all = AdvanceSplitting(**map, whole, 1000, 300, GoOn);
  std::vector<SplittingSample> samples;
  for (const int part : {100, 250, 150, 500}) {
    const auto stretch = AdvanceSplitting(**map, cut, part, 300, GoOn);
    ASSERT_TRUE(stretch.ok());
    samples.insert(samples.end(), stretch->samples.begin(), stretch->samples.end());
  }
  ASSERT_EQ(samples.size(), all->samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].iterate, static_cast<std::int64_t>(i));
    EXPECT_EQ(samples[i].point, all->samples[i].point);
    // The backward transient: exp(-300 * 0.377) is far below rounding.
    EXPECT_LT(AngleOfLines(samples[i].stable, all->samples[i].stable), 1e-14);
  }
  EXPECT_EQ(cut.pending.size(), 300U);
}

TEST(Splitting, TooShortASettlingShowsAsDisagreement) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  SplittingOrbit orbit = {.orbit = HenonStart(**map), .iterates = 0, .pending = {}};
  const auto stretch = AdvanceSplitting(**map, orbit, 100, 3, GoOn);
  ASSERT_TRUE(stretch.ok());
  EXPECT_GT(stretch->disagreement, 1e-3);
}

TEST(Splitting, CancelledOrbitIsAsItWas) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  SplittingOrbit orbit = {.orbit = HenonStart(**map), .iterates = 0, .pending = {}};
  const Point before = orbit.orbit.point;
  const auto stretch =
      AdvanceSplitting(**map, orbit, 100, 30, [](std::int64_t n) { return n < 10; });
  EXPECT_EQ(stretch.status().code(), absl::StatusCode::kCancelled);
  EXPECT_EQ(orbit.orbit.point, before);
  EXPECT_TRUE(orbit.pending.empty());
}

TEST(Splitting, RefusesWhatItCannotSplit) {
  SplittingOrbit orbit;
  const LinearMap line(SquareMatrix::Identity(1, 1));
  EXPECT_EQ(AdvanceSplitting(line, orbit, 10, 10, GoOn).status().code(),
            absl::StatusCode::kInvalidArgument);
  const auto map = Henon3dSystem().MakeMap({}, {});
  EXPECT_EQ(AdvanceSplitting(**map, orbit, 0, 10, GoOn).status().code(),
            absl::StatusCode::kInvalidArgument);
}

TEST(Splitting, SingularJacobianIsReported) {
  const LinearMap map(Eigen::Matrix2d{{1, 0}, {0, 0}});
  SplittingOrbit orbit = {
      .orbit = {Point::Zero(2), SquareMatrix::Identity(2, 2)}, .iterates = 0, .pending = {}};
  EXPECT_EQ(AdvanceSplitting(map, orbit, 10, 5, GoOn).status().code(),
            absl::StatusCode::kOutOfRange);
}

}  // namespace
}  // namespace celt
