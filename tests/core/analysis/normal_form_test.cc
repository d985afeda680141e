#include "core/analysis/normal_form.h"

#include <cmath>
#include <complex>

#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"
#include "tests/core/analysis/henon_fixed_point.h"

namespace celt {
namespace {

using Complex = std::complex<double>;

std::unique_ptr<Map> HenonAt(const HenonFixedPoints& henon, double x) {
  auto map = Henon3dSystem().MakeMap(
      {{"m1", henon.M1(x)}, {"m2", henon.m2}, {"a", henon.a}, {"b", henon.b}}, {});
  EXPECT_TRUE(map.ok()) << map.status();
  return *std::move(map);
}

/// x̄ = −x + α x² + β x³.
class Flip final : public Map {
 public:
  Flip(double alpha, double beta) : alpha_(alpha), beta_(beta) {}
  int dimension() const override { return 1; }
  absl::StatusOr<Image> Apply(const Point& p, Direction, Derivative) const override {
    const double x = p[0];
    return Image{.point = Point::Constant(1, -x + alpha_ * x * x + beta_ * x * x * x),
                 .time = 1,
                 .jacobian = SquareMatrix::Constant(1, 1, -1 + 2 * alpha_ * x + 3 * beta_ * x * x)};
  }

 private:
  double alpha_, beta_;
};

/// z̄ = e^{iθ} z (1 + d |z|²) in the plane.
class Circle final : public Map {
 public:
  Circle(double theta, double d) : turn_(std::polar(1.0, theta)), d_(d) {}
  int dimension() const override { return 2; }
  absl::StatusOr<Image> Apply(const Point& p, Direction, Derivative) const override {
    const Complex z(p[0], p[1]);
    const Complex image = turn_ * z * (1 + d_ * std::norm(z));
    const Complex by_z = turn_ * (1 + 2 * d_ * std::norm(z));
    const Complex by_conjugate = turn_ * d_ * z * z;
    const Complex by_x = by_z + by_conjugate;
    const Complex by_y = Complex(0, 1) * (by_z - by_conjugate);
    return Image{
        .point = Eigen::Vector2d(image.real(), image.imag()),
        .time = 1,
        .jacobian = Eigen::Matrix2d{{by_x.real(), by_y.real()}, {by_x.imag(), by_y.imag()}}};
  }

 private:
  Complex turn_;
  double d_;
};

TEST(PeriodDoublingForm, OfAMapOfTheLineIsItsTextbookValue) {
  // p = q = 1, B = 2α, C = 6β: c = β − ½ (2α)(−2)⁻¹(2α) = β + α².
  const auto super = PeriodDoublingForm(Flip(0.7, 0.3), Point::Zero(1), 1);
  ASSERT_TRUE(super.ok());
  EXPECT_NEAR(super->coefficient, 0.3 + 0.49, 1e-9);
  EXPECT_EQ(super->criticality, Criticality::kSupercritical);
  const auto sub = PeriodDoublingForm(Flip(0.1, -0.3), Point::Zero(1), 1);
  ASSERT_TRUE(sub.ok());
  EXPECT_NEAR(sub->coefficient, -0.3 + 0.01, 1e-9);
  EXPECT_EQ(sub->criticality, Criticality::kSubcritical);
}

TEST(PeriodDoublingForm, ThatVanishesLeavesTheCriticalityUnknown) {
  const auto form = PeriodDoublingForm(Flip(0.5, -0.25), Point::Zero(1), 1);
  ASSERT_TRUE(form.ok());
  EXPECT_LE(std::abs(form->coefficient), 1e-9);
  EXPECT_EQ(form->criticality, Criticality::kUnknown);
}

TEST(PeriodDoublingForm, OfTheHenonMapFollowsFromItsCompanionMatrix) {
  const HenonFixedPoints henon = {.m2 = 0.8, .a = -0.2, .b = 0.6};
  const double x = henon.DoublingX();
  // q = (1, −1, 1)/√3, B(q, q) = −2 q3² e3, (μ − A)⁻¹ e3 = (1, μ, μ²)/χ(μ), and p is the left
  // eigenvector (b/μ, (b/μ + m2)/μ, 1) at μ = −1 over its product with q.
  const double q3 = 1 / std::sqrt(3.0);
  const double p3 = 1 / (q3 * (-henon.b - (henon.b - henon.m2) + 1));
  const double expected = 2 * p3 * q3 * q3 * q3 / henon.Characteristic(1, x).real();
  const auto form = PeriodDoublingForm(*HenonAt(henon, x), Point::Constant(3, x), 1);
  ASSERT_TRUE(form.ok());
  // Second differences of a quadratic map's Jacobian vanish up to rounding over the step squared.
  EXPECT_NEAR(form->coefficient, expected, 1e-9);
  EXPECT_LT(form->error, 1e-9);
}

TEST(NeimarkSackerForm, OfItsOwnNormalFormIsTheCoefficient) {
  // |q| = 1 makes z = √2 w with w the coordinate along q, and d|z|² = 2d|w|².
  for (const double d : {-0.4, 0.3}) {
    const auto form = NeimarkSackerForm(Circle(1.1, d), Point::Zero(2), 1);
    ASSERT_TRUE(form.ok());
    EXPECT_NEAR(form->coefficient, 2 * d, 1e-9);
    EXPECT_EQ(form->criticality, d < 0 ? Criticality::kSupercritical : Criticality::kSubcritical);
  }
}

TEST(NeimarkSackerForm, OfTheHenonMapFollowsFromItsCompanionMatrix) {
  const HenonFixedPoints henon = {.m2 = -1.2, .a = 0.1, .b = 0.7};
  const double x = henon.NeimarkSackerX();
  const Complex mu(henon.Cosine(), std::sqrt(1 - henon.Cosine() * henon.Cosine()));
  // As above, with q = (1, μ, μ²)/√3 and conj(p) the left eigenvector.
  const Complex q3 = mu * mu / std::sqrt(3.0);
  const Complex left2 = (henon.b / mu + henon.m2) / mu;
  const Complex p3 = std::sqrt(3.0) / (henon.b / mu + left2 * mu + mu * mu);
  const Complex square = mu * mu;
  const Complex expected =
      std::conj(mu) * p3 * q3 * std::norm(q3) *
      (8.0 / henon.Characteristic(1, x) + 4.0 * square * square / henon.Characteristic(square, x)) /
      2.0;
  const auto form = NeimarkSackerForm(*HenonAt(henon, x), Point::Constant(3, x), 1);
  ASSERT_TRUE(form.ok());
  EXPECT_NEAR(form->coefficient, expected.real(), 1e-9);
  EXPECT_LT(form->error, 1e-9);
}

/// Just past the bifurcation, on its unstable side, an orbit near the fixed point stays near it
/// exactly when the coefficient calls it supercritical.
TEST(NeimarkSackerForm, CriticalityIsWhatOrbitsDo) {
  const HenonFixedPoints henon = {.m2 = -1.2, .a = 0.1, .b = 0.7};
  const double x = henon.NeimarkSackerX();
  const auto form = NeimarkSackerForm(*HenonAt(henon, x), Point::Constant(3, x), 1);
  ASSERT_TRUE(form.ok());
  bool stays = true;
  for (const double past : {x - 2e-3, x + 2e-3}) {
    const auto map = HenonAt(henon, past);
    Point point = Point::Constant(3, past + 1e-3);
    double farthest = 0;
    for (int i = 0; i < 20000 && farthest < 1; ++i) {
      const auto image = map->Apply(point, Direction::kForward, Derivative::kNone);
      if (!image.ok()) {
        farthest = 1;
        break;
      }
      point = image->point;
      farthest = std::max(farthest, (point - Point::Constant(3, past)).norm());
    }
    stays = stays && farthest < 0.3;
  }
  EXPECT_EQ(stays, form->criticality == Criticality::kSupercritical);
}

TEST(NeimarkSackerForm, SingularMatrixIsAStatus) {
  // At 1:3, e^{2iθ} is a multiplier itself.
  EXPECT_FALSE(NeimarkSackerForm(Circle(2 * std::acos(-1) / 3, 0.3), Point::Zero(2), 1).ok());
}

}  // namespace
}  // namespace celt
