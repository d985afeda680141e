#include "core/analysis/cycle.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"
#include "tests/core/analysis/stone_map.h"
#include "tests/core/reference.h"

namespace celt {
namespace {

std::unique_ptr<Map> Henon(const Parameters& parameters) {
  auto map = Henon3dSystem().MakeMap(parameters, {});
  EXPECT_TRUE(map.ok()) << map.status();
  return *std::move(map);
}

CycleReport Find(const Map& map, const Point& guess, int period,
                 const NewtonOptions& options = {}) {
  auto report = FindCycle(map, guess, period, options);
  EXPECT_TRUE(report.ok()) << report.status();
  return *std::move(report);
}

/// μ³ − (a − 2x) μ² − m2 μ − b, whose zeros are the multipliers of the fixed point (x, x, x).
Multiplier HenonCharacteristic(Multiplier mu, double x, double m2, double a, double b) {
  return mu * mu * mu - (a - 2 * x) * mu * mu - m2 * mu - b;
}

TEST(FindCycle, FixedPointOfTheHenonMapIsTheZeroOfItsQuadratic) {
  const auto map = Henon({{"m1", 0.3}, {"m2", 0.8}, {"a", -0.2}, {"b", 0.6}});
  const CycleReport report = Find(*map, Eigen::Vector3d(1, 0.5, 0.9), 1);
  ASSERT_TRUE(report.converged()) << report.message;
  // x² + (1 − b − m2 − a) x − m1 = 0; Newton's method ends at rounding.
  const double x = 0.1 + std::sqrt(0.01 + 0.3);
  EXPECT_LT((report.points[0] - Point::Constant(3, x)).norm(), 1e-14);
  EXPECT_LT(report.residual, 1e-14);
  EXPECT_EQ(report.minimal_period, 1);
  EXPECT_EQ(report.return_time, 1);
}

TEST(FindCycle, MultipliersAreTheZerosOfTheCharacteristicPolynomial) {
  const auto map = Henon({{"m1", 0.3}, {"m2", 0.8}, {"a", -0.2}, {"b", 0.6}});
  const CycleReport report = Find(*map, Eigen::Vector3d(1, 0.5, 0.9), 1);
  ASSERT_EQ(report.multipliers.size(), 3);
  for (const Multiplier& mu : report.multipliers) {
    EXPECT_LT(std::abs(HenonCharacteristic(mu, report.points[0][0], 0.8, -0.2, 0.6)), 1e-14);
  }
  EXPECT_GE(std::abs(report.multipliers[0]), std::abs(report.multipliers[1]));
  EXPECT_GE(std::abs(report.multipliers[1]), std::abs(report.multipliers[2]));
}

/// Points u, v of a cycle of period 2 have u + v = S and u v = P: subtract and add
/// v = m1 + b u + m2 v + a u − u² and the same with u and v exchanged.
TEST(FindCycle, CycleOfPeriodTwoOfTheHenonMapHasItsSumAndProduct) {
  const double m1 = 0.9, m2 = 0.1, a = 0.2, b = 0.3;
  const auto map = Henon({{"m1", m1}, {"m2", m2}, {"a", a}, {"b", b}});
  const double sum = 1 + b + a - m2;
  const double product = (sum * (1 - b - m2 - a) + sum * sum - 2 * m1) / 2;
  const double u = sum / 2 + std::sqrt(sum * sum / 4 - product);
  const CycleReport report = Find(*map, Eigen::Vector3d(u + 0.02, sum - u, u - 0.03), 2);
  ASSERT_TRUE(report.converged()) << report.message;
  EXPECT_EQ(report.minimal_period, 2);
  EXPECT_NEAR(report.points[0][0], u, 1e-14);
  EXPECT_NEAR(report.points[0][1], sum - u, 1e-14);
  EXPECT_EQ(report.return_time, 2);
  // The product of the multipliers is the determinant of DF².
  const Multiplier determinant =
      report.multipliers[0] * report.multipliers[1] * report.multipliers[2];
  EXPECT_NEAR(determinant.real(), b * b, 1e-14);
}

TEST(FindCycle, FixedPointFoundAsACycleOfPeriodSixSaysItsMinimalPeriod) {
  const auto map = Henon({{"m1", 0}, {"m2", 0.85}, {"b", 0.7}});
  const CycleReport once = Find(*map, Point::Constant(3, 0.56), 1);
  const CycleReport report = Find(*map, Point::Constant(3, 0.55), 6);
  ASSERT_TRUE(report.converged()) << report.message;
  EXPECT_EQ(report.minimal_period, 1);
  EXPECT_EQ(report.points.size(), 6);
  // Rounding of six factors below two.
  EXPECT_NEAR(std::abs(report.multipliers[0]), std::pow(std::abs(once.multipliers[0]), 6), 1e-12);
}

TEST(FindCycle, DampingReachesAFixedPointFromFarAway) {
  const auto map = Henon({{"m1", 0}, {"m2", 0.85}, {"b", 0.7}});
  const CycleReport report = Find(*map, Eigen::Vector3d(-40, 90, 120), 1);
  EXPECT_TRUE(report.converged()) << report.message;
}

TEST(FindCycle, MapWithoutFixedPointDoesNotConverge) {
  // Beyond the fold: x² + (1 − b − m2 − a) x − m1 has no real zero.
  const auto map = Henon({{"m1", -2}, {"m2", 0.85}, {"b", 0.7}});
  const CycleReport report = Find(*map, Point::Constant(3, 0.3), 1);
  EXPECT_FALSE(report.converged());
  EXPECT_FALSE(report.message.empty());
  EXPECT_TRUE(report.multipliers.empty());
}

TEST(FindCycle, OrbitThatEscapesLeftTheDomain) {
  const auto map = Henon({});
  const CycleReport report = Find(*map, Point::Constant(3, 50), 8);
  EXPECT_EQ(report.termination, CycleTermination::kLeftDomain);
  EXPECT_NE(report.message.find("escapes"), std::string::npos) << report.message;
}

TEST(FindCycle, IdentityIsSingular) {
  class Identity final : public Map {
    int dimension() const override { return 2; }
    absl::StatusOr<Image> Apply(const Point& x, Direction, Derivative) const override {
      return Image{.point = x, .time = 1, .jacobian = SquareMatrix::Identity(2, 2)};
    }
  };
  const CycleReport report = Find(Identity(), Point::Zero(2), 1);
  EXPECT_EQ(report.termination, CycleTermination::kSingular);
}

TEST(FindCycle, BadInputIsNamed) {
  const auto map = Henon({});
  const Point start = Point::Constant(3, 0.1);
  EXPECT_EQ(FindCycle(*map, start, 0).status().message(),
            "period: 0 is not allowed; it lies in [1, 256]");
  EXPECT_EQ(FindCycle(*map, start, 257).status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(FindCycle(*map, Point::Zero(2), 1).status().code(), absl::StatusCode::kInvalidArgument);
  NewtonOptions options;
  options.tolerance = std::nan("");
  EXPECT_EQ(FindCycle(*map, start, 1, options).status().message(),
            "tolerance: nan is not allowed; it lies in (0, 1]");
}

TEST(FindCycle, StoneHasItsReferenceFixedPoints) {
  for (const ReferenceFixedPoint& reference : ReferenceFixedPoints()) {
    const auto map = StoneMap({{"energy", reference.energy}, {"delta", reference.delta}});
    const CycleReport report = Find(*map, reference.point + Eigen::Vector3d(0.01, -0.01, 0.01), 1);
    ASSERT_TRUE(report.converged()) << report.message;
    // The reference's digits hold to 1e-11.
    EXPECT_LT((report.points[0] - reference.point).norm(), 1e-9);
    EXPECT_NEAR(report.return_time, reference.time, 1e-9);
    for (const Multiplier& mu : report.multipliers) {
      EXPECT_EQ(mu.imag(), 0);
      EXPECT_LT((reference.multipliers.array() - mu.real()).abs().minCoeff(), 1e-9);
    }
  }
}

TEST(FindCycle, AnglesAreGivenInTheMapsOwnRange) {
  const auto map = StoneMap({});
  const Eigen::Vector3d twin = ReferenceFixedPoints()[0].point;
  const CycleReport report = Find(*map, twin - Eigen::Vector3d(std::numbers::pi, 0, 0), 1);
  ASSERT_TRUE(report.converged()) << report.message;
  EXPECT_NEAR(report.points[0][0], twin[0] + std::numbers::pi, 1e-9);
}

}  // namespace
}  // namespace celt
