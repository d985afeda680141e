#include "core/analysis/bifurcation.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"
#include "tests/core/analysis/family.h"
#include "tests/core/analysis/henon_fixed_point.h"

namespace celt {
namespace {

/// What is asked of the parameter of a bifurcation; the closed forms are exact.
constexpr double kLocated = 1e-9;

/// All that happens to the fixed point x of the Hénon map while x goes from `from` to `to` along
/// the branch: m1 goes with it.
std::vector<Bifurcation> Along(const HenonFixedPoints& henon, double from, double to) {
  ContinuationOptions options;
  options.from = henon.M1(from);
  options.to = henon.M1(to);
  const MapFamily family =
      FamilyOf(Henon3dSystem(), "m1", {{"m2", henon.m2}, {"a", henon.a}, {"b", henon.b}});
  BranchState state = Start(family, options, {Point::Constant(3, from)});
  std::vector<Bifurcation> met = WholeBranch(family, options, state).bifurcations;
  for (const Bifurcation& bifurcation : met) EXPECT_TRUE(bifurcation.located);
  return met;
}

TEST(Bifurcation, PeriodDoublingOfTheHenonMapLiesWhereItsFormulaSays) {
  const HenonFixedPoints henon = {.m2 = 0.8, .a = -0.2, .b = 0.6};
  const auto met = OfType(Along(henon, 0.2, 0.9), BifurcationType::kPeriodDoubling);
  ASSERT_EQ(met.size(), 1);
  EXPECT_NEAR(met[0].point.parameter, henon.M1(henon.DoublingX()), kLocated);
  EXPECT_NEAR(met[0].point.cycle.points[0][0], henon.DoublingX(), kLocated);
  EXPECT_NEAR(met[0].critical[0].real(), -1, kLocated);
  EXPECT_LE(met[0].parameter_error, kLocated);
}

TEST(Bifurcation, FoldOfTheHenonMapLiesWhereItsFormulaSays) {
  const HenonFixedPoints henon = {.m2 = 0.8, .a = -0.2, .b = 0.6};
  ContinuationOptions options;
  options.from = 0.3;
  options.to = -1;
  const MapFamily family =
      FamilyOf(Henon3dSystem(), "m1", {{"m2", henon.m2}, {"a", henon.a}, {"b", henon.b}});
  BranchState state = Start(family, options, {Point::Constant(3, 0.65)});
  const auto met = OfType(WholeBranch(family, options, state).bifurcations, BifurcationType::kFold);
  ASSERT_EQ(met.size(), 1);
  EXPECT_NEAR(met[0].point.parameter, henon.M1(henon.FoldX()), kLocated);
  EXPECT_NEAR(met[0].point.cycle.points[0][0], henon.FoldX(), kLocated);
  EXPECT_NEAR(met[0].critical[0].real(), 1, kLocated);
}

TEST(Bifurcation, NeimarkSackerOfTheHenonMapLiesWhereItsFormulaSays) {
  const HenonFixedPoints henon = {.m2 = -1.2, .a = 0.1, .b = 0.7};
  const double x = henon.NeimarkSackerX();
  const auto met = OfType(Along(henon, x - 0.2, x + 0.3), BifurcationType::kNeimarkSacker);
  ASSERT_EQ(met.size(), 1);
  EXPECT_NEAR(met[0].point.parameter, henon.M1(x), kLocated);
  EXPECT_NEAR(met[0].angle, std::acos(henon.Cosine()), kLocated);
  EXPECT_NEAR(std::abs(met[0].critical[0]), 1, kLocated);
  EXPECT_EQ(met[0].resonance, "");
}

TEST(Bifurcation, StrongResonancesAreNamed) {
  // cos θ = −(1 + m2)/(2b) is −1/2 and 0.
  const HenonFixedPoints third = {.m2 = -0.3, .a = 0.1, .b = 0.7};
  const HenonFixedPoints fourth = {.m2 = -1, .a = 0.1, .b = 0.7};
  const auto name = [](const HenonFixedPoints& henon) {
    const double x = henon.NeimarkSackerX();
    const auto met = OfType(Along(henon, x - 0.1, x + 0.1), BifurcationType::kNeimarkSacker);
    return met.empty() ? std::string("none") : met[0].resonance;
  };
  EXPECT_EQ(name(third), "1:3");
  EXPECT_EQ(name(fourth), "1:4");
}

/// With a double zero μ of χ the third is b/μ², and the products of pairs, μ² + 2b/μ, add to −m2.
TEST(Bifurcation, MultipliersOfTheHenonMapMeetWhereTheCharacteristicHasADoubleZero) {
  const HenonFixedPoints henon = {.m2 = 0.8, .a = -0.2, .b = 0.6};
  const auto met = OfType(Along(henon, 0.2, 0.9), BifurcationType::kMultipliersMeet);
  ASSERT_FALSE(met.empty());
  for (const Bifurcation& meeting : met) {
    const double mu = meeting.critical[0].real();
    EXPECT_NEAR(mu * mu * mu + henon.m2 * mu + 2 * henon.b, 0, 1e-8);
    const double x = (henon.a - 2 * mu - henon.b / (mu * mu)) / 2;
    EXPECT_NEAR(meeting.point.parameter, henon.M1(x), 1e-8);
  }
}

/// μ and 1/μ with third multiplier b, or −1/b: the test function changes sign, the fixed point does
/// not change.
TEST(Bifurcation, NeutralSaddleIsNone) {
  // cos θ of the formula is 3: a real pair 3 ± √8.
  const HenonFixedPoints henon = {.m2 = -1 - 6 * 0.5, .a = 0.1, .b = 0.5};
  const double x = henon.NeimarkSackerX();
  EXPECT_TRUE(OfType(Along(henon, x - 0.1, x + 0.1), BifurcationType::kNeimarkSacker).empty());
}

TEST(Bifurcation, TwoBranchesThatCrossAreABranchPoint) {
  // x̄ = x + p x − x²: fixed points x = 0 and x = p, which cross at p = 0.
  class Transcritical final : public Map {
   public:
    explicit Transcritical(double p) : p_(p) {}
    int dimension() const override { return 1; }
    absl::StatusOr<Image> Apply(const Point& x, Direction, Derivative) const override {
      return Image{.point = Point::Constant(1, x[0] + p_ * x[0] - x[0] * x[0]),
                   .time = 1,
                   .jacobian = SquareMatrix::Constant(1, 1, 1 + p_ - 2 * x[0])};
    }

   private:
    double p_;
  };
  const MapFamily family = [](double p) -> absl::StatusOr<std::unique_ptr<Map>> {
    return std::make_unique<Transcritical>(p);
  };
  ContinuationOptions options;
  options.from = -1;
  options.to = 1.3;
  BranchState state = Start(family, options, {Point::Constant(1, 0)});
  const auto met = WholeBranch(family, options, state).bifurcations;
  EXPECT_EQ(state.end, BranchEnd::kReachedEnd) << state.message;
  ASSERT_EQ(met.size(), 1);
  EXPECT_EQ(met[0].type, BifurcationType::kBranchPoint);
  // At the crossing itself corrections are undefined: the bracket may stop short.
  EXPECT_NEAR(met[0].point.parameter, 0, 1e-6);
}

}  // namespace
}  // namespace celt
