#include "core/analysis/manifold.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "Eigen/LU"
#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

/// F = h ∘ A ∘ h⁻¹ with A diagonal and h(u, v, w) = (u, v + u², w + sin u): the manifold of 0 along
/// u is the curve (u, u², sin u).
class BentMap final : public Map {
 public:
  BentMap(double u, double v, double w) : a_(u, v, w) {}
  int dimension() const override { return 3; }
  absl::StatusOr<Image> Apply(const Point& x, Direction direction, Derivative) const override {
    const Eigen::Vector3d a =
        direction == Direction::kForward ? a_ : Eigen::Vector3d(a_.cwiseInverse());
    const Eigen::Vector3d straight(x[0], x[1] - x[0] * x[0], x[2] - std::sin(x[0]));
    const Eigen::Vector3d y = a.cwiseProduct(straight);
    if (std::abs(y[0]) > 3) return absl::OutOfRangeError("u is beyond 3");
    const Eigen::Matrix3d jacobian = Bend(y[0]) * a.asDiagonal() * Bend(x[0]).inverse();
    return Image{.point = Eigen::Vector3d(y[0], y[1] + y[0] * y[0], y[2] + std::sin(y[0])),
                 .time = 1,
                 .jacobian = jacobian};
  }

 private:
  static Eigen::Matrix3d Bend(double u) {
    return Eigen::Matrix3d{{1, 0, 0}, {2 * u, 1, 0}, {std::cos(u), 0, 1}};
  }
  Eigen::Vector3d a_;
};

struct Traced {
  std::vector<ManifoldPoint> points;
  ManifoldSide side;
};

Traced Trace(const Map& map, const Point& fixed_point, Direction direction, int side,
             const ManifoldOptions& options) {
  Traced traced;
  const auto saddle = MakeSaddle(map, {{fixed_point}}, direction);
  EXPECT_TRUE(saddle.ok()) << saddle.status();
  auto start = StartManifold(map, *saddle, side, options);
  EXPECT_TRUE(start.ok()) << start.status();
  traced.side = *std::move(start);
  while (!traced.side.done) {
    const absl::Status status =
        AdvanceManifold(map, *saddle, options, traced.side, [&](const ManifoldPoint& point) {
          traced.points.push_back(point);
          return true;
        });
    EXPECT_TRUE(status.ok()) << status;
  }
  return traced;
}

ManifoldOptions OfLength(double length) {
  ManifoldOptions options;
  options.length = length;
  return options;
}

void ExpectBentCurve(const Traced& traced, int side) {
  EXPECT_EQ(traced.side.end, ManifoldEnd::kLength);
  double length = 0;
  const Point* before = nullptr;
  for (const ManifoldPoint& at : traced.points) {
    const double u = at.point[0];
    EXPECT_GT(side * u, 0);
    // The first segment is off by its linear_error, 1e-6 of a step of at most 1e-2, which is
    // crushed by iterates; what stays is rounding.
    EXPECT_NEAR(at.point[1], u * u, 1e-8);
    EXPECT_NEAR(at.point[2], std::sin(u), 1e-8);
    if (before != nullptr) {
      const double spacing = (at.point - *before).norm();
      EXPECT_LE(spacing, 0.01);
      EXPECT_GT(side * u, side * (*before)[0]) << "in order";
      length += spacing;
    }
    before = &at.point;
    EXPECT_NEAR(at.arc_length, length + traced.points[0].arc_length, 1e-9);
  }
  EXPECT_GE(traced.points.back().arc_length, 1);
  EXPECT_LT(traced.points.back().arc_length, 1.01);
}

TEST(Manifold, UnstableOneOfABentMapIsItsCurveOnBothSides) {
  const BentMap map(1.5, 0.5, -0.3);
  for (const int side : {1, -1}) {
    ExpectBentCurve(Trace(map, Point::Zero(3), Direction::kForward, side, OfLength(1)), side);
  }
}

TEST(Manifold, KeepsItsSideUnderANegativeMultiplier) {
  const BentMap map(-1.5, 0.5, -0.3);
  for (const int side : {1, -1}) {
    ExpectBentCurve(Trace(map, Point::Zero(3), Direction::kForward, side, OfLength(1)), side);
  }
}

TEST(Manifold, IsACurveHoweverSmallItsParts) {
  const BentMap map(1.5, 0.5, -0.3);
  ManifoldOptions options = OfLength(1);
  options.most_iterates = 1;
  options.most_visits = 3;
  ExpectBentCurve(Trace(map, Point::Zero(3), Direction::kForward, 1, options), 1);
}

TEST(Manifold, StableOneIsFoundBackward) {
  const BentMap map(0.6, 2, -3);
  ExpectBentCurve(Trace(map, Point::Zero(3), Direction::kBackward, 1, OfLength(1)), 1);
}

TEST(Manifold, EndsWhereItLeavesTheDomain) {
  const BentMap map(1.5, 0.5, -0.3);
  const Traced traced = Trace(map, Point::Zero(3), Direction::kForward, 1, OfLength(100));
  EXPECT_EQ(traced.side.end, ManifoldEnd::kLost);
  EXPECT_EQ(traced.side.message, "u is beyond 3");
  EXPECT_GT(traced.points.back().point[0], 2) << "what came before is kept";
}

TEST(Manifold, EndsAtTheMostPoints) {
  const BentMap map(1.5, 0.5, -0.3);
  ManifoldOptions options = OfLength(2);
  options.most_points = 100;
  const Traced traced = Trace(map, Point::Zero(3), Direction::kForward, 1, options);
  EXPECT_EQ(traced.side.end, ManifoldEnd::kMostPoints);
}

TEST(Manifold, WindingUpAtAnAttractorEndsByGenerations) {
  // sin-like: u → 2u/(1 + u²) has its attractor at u = 1.
  class Saturating final : public Map {
   public:
    int dimension() const override { return 2; }
    absl::StatusOr<Image> Apply(const Point& x, Direction, Derivative) const override {
      const double q = 1 + x[0] * x[0];
      return Image{.point = Eigen::Vector2d(2 * x[0] / q, x[1] / 2),
                   .time = 1,
                   .jacobian = Eigen::Matrix2d{{2 * (2 - q) / (q * q), 0}, {0, 0.5}}};
    }
  };
  ManifoldOptions options = OfLength(3);
  options.most_generations = 60;
  const Traced traced = Trace(Saturating(), Point::Zero(2), Direction::kForward, 1, options);
  EXPECT_EQ(traced.side.end, ManifoldEnd::kMostGenerations);
  EXPECT_NEAR(traced.points.back().arc_length, 1, 1e-6);
}

TEST(Manifold, OfTheHenonMapIsInvariantAndResolved) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  const ManifoldOptions options = OfLength(6);
  const Traced traced =
      Trace(**map, Eigen::Vector3d::Constant(0.55), Direction::kForward, 1, options);
  EXPECT_EQ(traced.side.end, ManifoldEnd::kLength);
  EXPECT_GT(traced.side.generation, 10);
  double sharpest = 0;
  for (std::size_t i = 1; i + 1 < traced.points.size(); ++i) {
    const Point a = traced.points[i].point - traced.points[i - 1].point;
    const Point b = traced.points[i + 1].point - traced.points[i].point;
    EXPECT_LE(b.norm(), options.most_spacing);
    if (std::min(a.norm(), b.norm()) > options.least_spacing) {
      sharpest = std::max(sharpest, std::acos(std::min(1.0, a.dot(b) / (a.norm() * b.norm()))));
    }
  }
  // Where generations meet the angle is not looked at: twice the angle asked for.
  EXPECT_LE(sharpest, 2 * options.most_turning);
}

TEST(Manifold, BadOptionsAreRefused) {
  const BentMap map(1.5, 0.5, -0.3);
  const auto saddle = MakeSaddle(map, {{Point::Zero(3)}}, Direction::kForward);
  EXPECT_FALSE(StartManifold(map, *saddle, 0, OfLength(1)).ok());
  EXPECT_FALSE(StartManifold(map, *saddle, 1, OfLength(-1)).ok());
  ManifoldOptions options;
  options.scale = Eigen::Vector2d(1, 1);
  EXPECT_FALSE(StartManifold(map, *saddle, 1, options).ok());
}

TEST(Manifold, CancelledGenerationComesAgain) {
  const BentMap map(1.5, 0.5, -0.3);
  const auto saddle = MakeSaddle(map, {{Point::Zero(3)}}, Direction::kForward);
  auto side = StartManifold(map, *saddle, 1, OfLength(1));
  ASSERT_TRUE(side.ok());
  const ManifoldSide before = *side;
  EXPECT_EQ(
      AdvanceManifold(map, *saddle, OfLength(1), *side, [](const ManifoldPoint&) { return false; })
          .code(),
      absl::StatusCode::kCancelled);
  EXPECT_EQ(side->written, before.written);
  EXPECT_EQ(side->generation, before.generation);
}

}  // namespace
}  // namespace celt
