#include "core/analysis/lyapunov.h"

#include <cmath>
#include <numbers>
#include <string>

#include "core/map/henon3d_system.h"
#include "core/map/lorenz_system.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

bool GoOn(std::int64_t) { return true; }

/// x → A x: its exponents are the logarithms of the moduli of A's eigenvalues, exactly.
class LinearMap final : public Map {
 public:
  explicit LinearMap(SquareMatrix a) : a_(std::move(a)) {}
  int dimension() const override { return static_cast<int>(a_.rows()); }
  absl::StatusOr<Image> Apply(const Point& x, Direction, Derivative) const override {
    return Image{.point = 0 * (a_ * x), .time = 2, .jacobian = a_};
  }

 private:
  SquareMatrix a_;
};

struct Run {
  std::int64_t transient = 1000;
  std::int64_t batch = 1000;
  int batches = 8;
};

LyapunovReport Spectrum(const System& system, const Parameters& parameters, int orbits,
                        std::uint64_t seed, const Run& run) {
  const auto map = system.MakeMap(parameters, {});
  EXPECT_TRUE(map.ok()) << map.status();
  std::vector<FramedOrbit> frames =
      DrawStarts(system.DefaultStart(), system.StartSpread(), orbits, seed);
  EXPECT_TRUE(AdvanceFrames(**map, frames, run.transient, GoOn).ok());
  std::vector<LyapunovSums> batches;
  for (int batch = 0; batch < run.batches; ++batch) {
    const auto sums = AdvanceFrames(**map, frames, run.batch, GoOn);
    EXPECT_TRUE(sums.ok()) << sums.status();
    batches.insert(batches.end(), sums->begin(), sums->end());
  }
  return Summarize(batches);
}

void ExpectWithin(const Estimate& estimate, double truth, double errors, double digits) {
  EXPECT_LE(std::abs(estimate.value - truth), errors * estimate.standard_error + digits)
      << estimate.value << " ± " << estimate.standard_error << ", expected " << truth;
}

TEST(Lyapunov, ExponentsOfALinearMapAreLogarithmsOfItsEigenvalues) {
  const LinearMap map(Eigen::Matrix3d{{0.5, 1, -2}, {0, -3, 0.3}, {0, 0, 0.01}});
  std::vector<FramedOrbit> orbits = DrawStarts(Point::Zero(3), Point::Zero(3), 1, 1);
  ASSERT_TRUE(AdvanceFrames(map, orbits, 100, GoOn).ok());
  const auto sums = AdvanceFrames(map, orbits, 10, GoOn);
  ASSERT_TRUE(sums.ok());
  const LyapunovReport report = Summarize(*sums);
  // The frame has converged like (1/6)^100: what is left is rounding.
  EXPECT_NEAR(report.per_iterate[0].value, std::log(3), 1e-14);
  EXPECT_NEAR(report.per_iterate[1].value, std::log(0.5), 1e-14);
  EXPECT_NEAR(report.per_iterate[2].value, std::log(0.01), 1e-14);
  EXPECT_NEAR(report.per_time[0].value, std::log(3) / 2, 1e-14);
  EXPECT_EQ(report.iterates, 10);
}

TEST(Lyapunov, SingularJacobianIsReportedNotReturned) {
  const LinearMap map(Eigen::Matrix2d{{1, 0}, {0, 0}});
  std::vector<FramedOrbit> orbits = DrawStarts(Point::Zero(2), Point::Zero(2), 1, 1);
  EXPECT_EQ(AdvanceFrames(map, orbits, 3, GoOn).status().code(), absl::StatusCode::kOutOfRange);
}

TEST(Lyapunov, TickStopsTheOrbits) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  std::vector<FramedOrbit> orbits =
      DrawStarts(Henon3dSystem().DefaultStart(), Point::Zero(3), 3, 1);
  std::int64_t ticks = 0;
  const auto sums =
      AdvanceFrames(**map, orbits, 1000, [&](std::int64_t n) { return (ticks = n) < 10; });
  EXPECT_EQ(sums.status().code(), absl::StatusCode::kCancelled);
  EXPECT_LT(ticks, 1000);
}

TEST(Lyapunov, LostOrbitIsAStatusOfTheMap) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  std::vector<FramedOrbit> orbits = DrawStarts(Eigen::Vector3d(5, 5, 5), Point::Zero(3), 1, 1);
  EXPECT_EQ(AdvanceFrames(**map, orbits, 1000, GoOn).status().code(),
            absl::StatusCode::kOutOfRange);
}

/// Statistical tolerances: four of the estimate's own standard errors (a fixed seed, so no flakes),
/// plus half a unit of the reference's last digit.
TEST(Lyapunov, HenonMapHasItsPublishedSpectrumAtM2Of085) {
  const LyapunovReport report = Spectrum(Henon3dSystem(), {{"m2", 0.85}}, 8, 1,
                                         {.transient = 2000, .batch = 12500, .batches = 4});
  ExpectWithin(report.per_iterate[0], 0.02008, 4, 5e-6);
  ExpectWithin(report.per_iterate[1], 0.0001, 4, 5e-5);
  ExpectWithin(report.per_iterate[2], -0.37684, 4, 5e-6);
  EXPECT_LT(report.per_iterate[0].standard_error, 2e-4);
}

TEST(Lyapunov, HenonMapHasItsPublishedSpectrumAtM2Of0815) {
  const LyapunovReport report = Spectrum(Henon3dSystem(), {{"m2", 0.815}}, 8, 1,
                                         {.transient = 2000, .batch = 12500, .batches = 4});
  ExpectWithin(report.per_iterate[0], 0.00848, 4, 5e-6);
  ExpectWithin(report.per_iterate[1], 0.0, 4, 5e-5);
  ExpectWithin(report.per_iterate[2], -0.36516, 4, 5e-6);
  EXPECT_LT(report.per_iterate[0].standard_error, 2e-4);
}

TEST(Lyapunov, SumOfTheHenonMapIsTheLogarithmOfItsDeterminant) {
  const LyapunovReport report =
      Spectrum(Henon3dSystem(), {}, 2, 1, {.transient = 10, .batch = 1000});
  // det DF = 0.7 at every point: rounding of 16000 logarithms.
  EXPECT_NEAR(report.sum_per_iterate.value, std::log(0.7), 1e-13);
}

TEST(Lyapunov, LorenzFlowHasItsKnownSpectrumPerUnitTime) {
  const LyapunovReport report =
      Spectrum(LorenzSystem(), {}, 4, 1, {.transient = 40, .batch = 200, .batches = 4});
  ExpectWithin(report.per_time[0], 0.9056, 4, 5e-5);
  ExpectWithin(report.per_time[1], 0, 4, 5e-5);
  ExpectWithin(report.per_time[2], -14.5723, 4, 5e-5);
  EXPECT_LT(report.per_time[0].standard_error, 0.03);
  // Liouville: the divergence is constant. The integrator's tolerance, 1e-11 a step, some 30 steps
  // a unit of time.
  EXPECT_NEAR(report.sum_per_time.value, -(10 + 1 + 8.0 / 3), 1e-8);
}

TEST(Lyapunov, StandardErrorCoversTheTruthInMostOfTwentySeeds) {
  int inside = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const LyapunovReport report = Spectrum(Henon3dSystem(), {{"m2", 0.85}}, 8, seed,
                                           {.transient = 2000, .batch = 625, .batches = 4});
    const Estimate& first = report.per_iterate[0];
    if (std::abs(first.value - 0.02008) <= 2 * first.standard_error) ++inside;
  }
  // Two standard errors hold 95 % of the estimates: 16 or fewer of 20 come once in 60.
  EXPECT_GE(inside, 17);
}

TEST(Lyapunov, ConditionsCarryTheirMargins) {
  const LyapunovReport report =
      Spectrum(Henon3dSystem(), {}, 4, 1, {.transient = 1000, .batch = 2000, .batches = 4});
  ASSERT_EQ(report.conditions.size(), 4);
  for (const LyapunovCondition& condition : report.conditions)
    EXPECT_TRUE(condition.holds) << condition.name;
  const LyapunovCondition& first = report.conditions[0];
  EXPECT_EQ(std::string(first.name), "lambda1 > 0");
  EXPECT_DOUBLE_EQ(first.slack.value, report.per_iterate[0].value);
  EXPECT_DOUBLE_EQ(first.margin, first.slack.value / report.per_iterate[0].standard_error);
}

TEST(Summarize, SingleBatchClaimsNoError) {
  const LyapunovSums batch = {.iterates = 4, .time = 2, .log_stretch = Eigen::Vector3d(1, 0, -2)};
  const LyapunovReport report = Summarize({&batch, 1});
  EXPECT_EQ(report.per_iterate[0].value, 0.25);
  EXPECT_EQ(report.per_time[2].value, -1);
  EXPECT_EQ(report.return_time.value, 0.5);
  EXPECT_EQ(report.per_iterate[0].standard_error, 0);
}

TEST(Summarize, StandardErrorIsThatOfTheMeanOfBatchMeans) {
  std::vector<LyapunovSums> batches;
  for (const double mean : {1.0, 2.0, 4.0, 5.0}) {
    batches.push_back({.iterates = 10, .time = 10, .log_stretch = Eigen::Vector2d(10 * mean, -10)});
  }
  const LyapunovReport report = Summarize(batches);
  EXPECT_DOUBLE_EQ(report.per_iterate[0].value, 3);
  // Sample variance (4 + 1 + 1 + 4)/3 over 4 batches.
  EXPECT_DOUBLE_EQ(report.per_iterate[0].standard_error, std::sqrt(10.0 / 3 / 4));
  EXPECT_TRUE(report.conditions.empty()) << "the paper's conditions speak of three dimensions";
}

TEST(KaplanYorke, InterpolatesBetweenDimensions) {
  const std::vector<double> lorenz = {0.9056, 0, -14.5723};
  EXPECT_DOUBLE_EQ(KaplanYorkeDimension(lorenz), 2 + 0.9056 / 14.5723);
  EXPECT_EQ(KaplanYorkeDimension(std::vector<double>{-0.1, -1}), 0);
  EXPECT_EQ(KaplanYorkeDimension(std::vector<double>{1, -0.5}), 2);
}

TEST(DrawStarts, DependOnTheSeedAlone) {
  const Point start = Eigen::Vector3d(1, 2, 3);
  const Point spread = Eigen::Vector3d(0.1, 0, 0.1);
  const auto a = DrawStarts(start, spread, 4, 7);
  const auto b = DrawStarts(start, spread, 8, 7);
  const auto c = DrawStarts(start, spread, 4, 8);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(a[i].point, b[i].point) << "more orbits leave the first ones as they were";
    EXPECT_NE(a[i].point, c[i].point);
    EXPECT_LE(std::abs(a[i].point[0] - 1), 0.1);
    EXPECT_EQ(a[i].point[1], 2);
  }
  EXPECT_EQ(DrawStarts(start, spread, 1, 7)[0].point, start);
}

}  // namespace
}  // namespace celt
