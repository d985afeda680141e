#include "core/analysis/saddle.h"

#include <cmath>

#include "core/analysis/cycle.h"
#include "core/analysis/line_angle.h"
#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

/// The fixed point (c, c, c), c = b + m2 − 1, of the default Hénon map.
const Point kFixedPoint = Eigen::Vector3d::Constant(0.55);

TEST(Saddle, OfTheHenonMapHasItsMultiplierAndItsTangent) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  const auto saddle = MakeSaddle(**map, {{kFixedPoint}}, Direction::kForward);
  ASSERT_TRUE(saddle.ok()) << saddle.status();
  EXPECT_EQ(saddle->iterates, 2) << "the multiplier is negative";
  const double multiplier = -std::sqrt(saddle->expansion);
  // λ³ = b + m2 λ − 2c λ², with the eigenvector (1, λ, λ²): sensitive to rounding by about 1.
  EXPECT_NEAR(std::pow(multiplier, 3), 0.7 + 0.85 * multiplier - 1.1 * multiplier * multiplier,
              1e-13);
  const Point tangent = Eigen::Vector3d(1, multiplier, multiplier * multiplier).normalized();
  EXPECT_LT(AngleOfLines(saddle->tangent, tangent), 1e-13);
  EXPECT_NEAR(saddle->normal.dot(saddle->tangent), 1, 1e-14);
  const auto image = (*map)->Apply(kFixedPoint, Direction::kForward, Derivative::kJacobian);
  EXPECT_LT((image->jacobian.transpose() * saddle->normal - multiplier * saddle->normal).norm(),
            1e-13);
}

TEST(Saddle, WithoutAOneDimensionalManifoldIsRefusedWithItsMultipliers) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  const auto saddle = MakeSaddle(**map, {{kFixedPoint}}, Direction::kBackward);
  EXPECT_EQ(saddle.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_NE(saddle.status().message().find("has 2 multipliers inside the unit circle"),
            std::string::npos)
      << saddle.status();
  EXPECT_NE(saddle.status().message().find("-1.3"), std::string::npos) << saddle.status();
}

TEST(Saddle, AtAPointThatIsNoCycleIsRefused) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  const Point off = kFixedPoint + Point(Eigen::Vector3d::Constant(1e-3));
  EXPECT_EQ(MakeSaddle(**map, {{off}}, Direction::kForward).status().code(),
            absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(MakeSaddle(**map, {}, Direction::kForward).status().code(),
            absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace celt
