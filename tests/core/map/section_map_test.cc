#include "core/map/section_map.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "Eigen/Eigenvalues"
#include "Eigen/LU"
#include "core/map/celtic_stone_system.h"
#include "gtest/gtest.h"
#include "tests/core/reference.h"

namespace celt {
namespace {

constexpr double kPi = std::numbers::pi;

std::unique_ptr<Map> StoneMap(const Numerics& numerics = {}, const Parameters& parameters = {}) {
  auto map = CelticStoneSystem().MakeMap(parameters, numerics);
  EXPECT_TRUE(map.ok()) << map.status();
  return *std::move(map);
}

Image Applied(const Map& map, const Point& x, Direction direction = Direction::kForward) {
  const auto image = map.Apply(x, direction, Derivative::kJacobian);
  EXPECT_TRUE(image.ok()) << image.status();
  return image.ok() ? *image : Image{};
}

/// A few points that are not on the attractor, some with their twins' signs.
std::vector<Point> SomePoints() {
  return {Eigen::Vector3d(2.1, -0.65, -0.37), Eigen::Vector3d(2.3, -0.5, -0.2),
          Eigen::Vector3d(0.4, 0.3, -0.1), Eigen::Vector3d(4.0, 0.2, 0.5)};
}

struct Errors {
  double point = 0;
  double time = 0;
  double jacobian = 0;  ///< relative to the largest entry
};

Errors LargestErrors(const Numerics& numerics) {
  const auto map = StoneMap(numerics);
  Errors errors;
  for (const ReferenceIterate& reference : ReferenceIterates()) {
    const Image image = Applied(*map, reference.point);
    errors.point =
        std::max(errors.point, map->Difference(image.point, reference.image).cwiseAbs().maxCoeff());
    errors.time = std::max(errors.time, std::abs(image.time - reference.time));
    errors.jacobian =
        std::max(errors.jacobian, (image.jacobian - reference.jacobian).cwiseAbs().maxCoeff() /
                                      reference.jacobian.cwiseAbs().maxCoeff());
  }
  return errors;
}

TEST(SectionMap, HasTheStatedErrorByDefault) {
  // The fast engine at 1e-11: 5 tolerances, and 30 for the Jacobian.
  const Errors errors = LargestErrors({});
  EXPECT_LT(errors.point, 5e-11);
  EXPECT_LT(errors.time, 5e-11);
  EXPECT_LT(errors.jacobian, 3e-10);
}

TEST(SectionMap, ErrorFollowsTheToleranceWithArkode) {
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const Errors errors = LargestErrors({.tolerance = tolerance, .engine = Engine::kArkode});
    // Measured: 0.2 to 1 times the tolerance, and 2 to 7 times for the Jacobian.
    EXPECT_LT(errors.point, 2 * tolerance);
    EXPECT_LT(errors.time, 2 * tolerance);
    EXPECT_LT(errors.jacobian, 15 * tolerance);
  }
}

TEST(SectionMap, ErrorFollowsTheToleranceWithCvode) {
  for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
    const Errors errors = LargestErrors({.tolerance = tolerance, .engine = Engine::kCvode});
    // The errors of a thousand steps add up at worst. Measured: 60 to 220, and 140 to 250 for the
    // Jacobian.
    EXPECT_LT(errors.point, 1000 * tolerance);
    EXPECT_LT(errors.time, 1000 * tolerance);
    EXPECT_LT(errors.jacobian, 1000 * tolerance);
  }
}

TEST(SectionMap, KeepsTheReferenceFixedPointsWithTheirMultipliers) {
  ASSERT_EQ(ReferenceFixedPoints().size(), 4u);
  for (const ReferenceFixedPoint& reference : ReferenceFixedPoints()) {
    const auto map = StoneMap({}, {{"energy", reference.energy}, {"delta", reference.delta}});
    const Image image = Applied(*map, reference.point);
    EXPECT_LT(map->Difference(image.point, reference.point).norm(), 1e-10) << reference.energy;
    EXPECT_NEAR(image.time, reference.time, 1e-10);
    Eigen::Vector3d multipliers =
        Eigen::EigenSolver<Eigen::Matrix3d>(image.jacobian).eigenvalues().real();
    std::ranges::sort(multipliers);
    EXPECT_LT((multipliers - reference.multipliers).cwiseAbs().maxCoeff(), 1e-8) << multipliers;
  }
}

TEST(SectionMap, TwinsAHalfTurnApartMoveAlike) {
  const auto map = StoneMap();
  const Point half_turn = Eigen::Vector3d(kPi, 0, 0);
  for (const Point& x : SomePoints()) {
    const Image image = Applied(*map, x);
    const Image twin = Applied(*map, x + half_turn);
    // Tolerance 1e-11 and 2π rounded; the Jacobian's entries are of size 30.
    EXPECT_LT(map->Difference(twin.point, image.point + half_turn).norm(), 1e-10);
    EXPECT_LT((twin.jacobian - image.jacobian).norm(), 1e-8);
  }
}

TEST(SectionMap, BothInvolutionsReverseTime) {
  const auto map = StoneMap();
  for (const double turn : {0.0, kPi}) {
    const auto involution = [turn](const Point& x) -> Point {
      return Eigen::Vector3d(x[0] + turn, -x[1], -x[2]);
    };
    for (const Point& x : SomePoints()) {
      // F∘I∘F∘I = id.
      const Image there = Applied(*map, involution(x));
      const Image back = Applied(*map, involution(there.point));
      // The second application stretches the first one's error of 1e-11 by up to a Jacobian of
      // size 30.
      EXPECT_LT(map->Difference(back.point, x).norm(), 1e-9) << x.transpose();
      EXPECT_NEAR(there.time, back.time, 1e-9);
    }
  }
}

TEST(SectionMap, BackwardUndoesForwardWithItsJacobian) {
  const auto map = StoneMap();
  for (const Point& x : SomePoints()) {
    const Image there = Applied(*map, x);
    const Image back = Applied(*map, there.point, Direction::kBackward);
    EXPECT_LT(map->Difference(back.point, x).norm(), 1e-9);
    EXPECT_NEAR(back.time, there.time, 1e-10);
    // Entries of size 30 in both factors.
    EXPECT_LT((back.jacobian * there.jacobian - SquareMatrix::Identity(3, 3)).norm(), 1e-6);
  }
}

TEST(SectionMap, JacobianIsItsDerivative) {
  const auto map = StoneMap({.tolerance = 1e-13});
  // Central differences err by h² times third derivatives of size 1e4, and by the map's error over
  // h.
  constexpr double kStep = 2e-6;
  for (const Point& x : SomePoints()) {
    const Image image = Applied(*map, x);
    for (int j = 0; j < 3; ++j) {
      const Point h = kStep * Eigen::Vector3d::Unit(j);
      const Point difference =
          map->Difference(Applied(*map, x + h).point, Applied(*map, x - h).point) / (2 * kStep);
      EXPECT_LT((image.jacobian.col(j) - difference).norm(), 1e-6 * image.jacobian.norm())
          << x.transpose();
    }
  }
}

TEST(SectionMap, LogarithmOfItsDeterminantAddsUpToTheSumOfTheExponents) {
  const auto map = StoneMap({.tolerance = 1e-8});
  const Point start = CelticStoneSystem().DefaultStart() + Eigen::Vector3d(1e-3, 0, 0);
  double sum = 0;
  double least = 1;
  const Advance advance{.iterates = 1000, .derivative = Derivative::kJacobian};
  const auto statuses = map->AdvanceAll({&start, 1}, advance, [&](int, const Image& image) {
    least = std::min(least, image.jacobian.determinant());
    sum += std::log(image.jacobian.determinant());
    return true;
  });
  ASSERT_TRUE(statuses[0].ok()) << statuses[0];
  EXPECT_GT(least, 0);  // orientation is kept
  // Reference -0.17230 per iterate; the mean over 1000 iterates scatters by about 1e-4.
  EXPECT_NEAR(sum / 1000, -0.17230, 5e-4);
}

TEST(SectionMap, ManyOrbitsAtOnceAreTheSameOrbits) {
  const auto map = StoneMap({.tolerance = 1e-8});
  const std::vector<Point> starts = SomePoints();
  std::vector<std::vector<Point>> orbits(starts.size());
  const auto statuses =
      map->AdvanceAll(starts, {.iterates = 3}, [&](int orbit, const Image& image) {
        orbits[orbit].push_back(image.point);
        return true;
      });
  for (std::size_t i = 0; i < starts.size(); ++i) {
    ASSERT_TRUE(statuses[i].ok()) << statuses[i];
    ASSERT_EQ(orbits[i].size(), 3u);
    Point x = starts[i];
    for (const Point& y : orbits[i]) {
      x = map->Apply(x, Direction::kForward, Derivative::kNone)->point;
      EXPECT_EQ(x, y);
    }
  }
}

TEST(SectionMap, AnOrbitEndsWhenItsVisitorHasSeenEnough) {
  const auto map = StoneMap({.tolerance = 1e-6});
  const std::vector<Point> starts = SomePoints();
  std::vector<int> visits(starts.size());
  const auto statuses = map->AdvanceAll(
      starts, {.iterates = 3}, [&](int orbit, const Image&) { return ++visits[orbit] <= orbit; });
  EXPECT_EQ(visits, (std::vector<int>{1, 2, 3, 3}));
  for (const absl::Status& status : statuses) EXPECT_TRUE(status.ok());
}

TEST(SectionMap, TellsABadStartFromALostOne) {
  const auto map = StoneMap({.tolerance = 1e-8});
  const std::vector<Point> starts = {Eigen::Vector3d(1, 1.5, 0), Eigen::Vector3d(1, 0.9, -0.9),
                                     SomePoints()[0]};
  int visits = 0;
  const auto statuses =
      map->AdvanceAll(starts, {.iterates = 1}, [&](int, const Image&) { return ++visits > 0; });
  EXPECT_EQ(statuses[0],
            absl::InvalidArgumentError("l_over_g: 1.5 is not allowed; must lie in (-1, 1)"));
  EXPECT_EQ(statuses[1].code(), absl::StatusCode::kOutOfRange);
  EXPECT_TRUE(statuses[2].ok());
  EXPECT_EQ(visits, 1);
}

TEST(SectionMap, RefusesAPointOfAnotherDimension) {
  EXPECT_EQ(
      StoneMap()->Apply(Point::Zero(2), Direction::kForward, Derivative::kNone).status().code(),
      absl::StatusCode::kInvalidArgument);
}

TEST(SectionMap, DifferenceOfAnglesGoesTheShortWay) {
  const auto map = StoneMap();
  const Point a = Eigen::Vector3d(0.1, 0.5, 0);
  const Point b = Eigen::Vector3d(2 * kPi - 0.1, 0.25, 0);
  EXPECT_NEAR(map->Difference(a, b)[0], 0.2, 1e-15);
  EXPECT_EQ(map->Difference(a, b)[1], 0.25);
}

}  // namespace
}  // namespace celt
