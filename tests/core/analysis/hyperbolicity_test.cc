#include "core/analysis/hyperbolicity.h"

#include <cmath>

#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

bool GoOn(std::int64_t) { return true; }

HyperbolicityRun OfLength(std::int64_t iterates) {
  HyperbolicityRun run;
  run.iterates = iterates;
  return run;
}

HyperbolicityReport Measure(const Parameters& parameters, const HyperbolicityRun& run) {
  const System& system = Henon3dSystem();
  const auto map = system.MakeMap(parameters, {});
  EXPECT_TRUE(map.ok()) << map.status();
  const FramedOrbit start = DrawStarts(system.DefaultStart(), system.StartSpread(), 2, 1).front();
  const auto report = MeasureHyperbolicity(**map, start, run, GoOn);
  EXPECT_TRUE(report.ok()) << report.status();
  return report.ok() ? *report : HyperbolicityReport();
}

const HyperbolicityTest& Find(const HyperbolicityReport& report, const std::string& name) {
  for (const HyperbolicityTest& test : report.tests) {
    if (test.name == name) return test;
  }
  ADD_FAILURE() << "no test " << name;
  return report.tests.front();
}

/// The orbit's length of the reference, and its whitening by as good as the whole orbit.
constexpr HyperbolicityRun kReferenceRun = {.transient = 2000,
                                            .scout = 20000,
                                            .iterates = 100000,
                                            .stretch = 2000,
                                            .options = {.lmp_stride = 5}};

TEST(Hyperbolicity, HenonMapAtM2Of0815IsPseudoHyperbolic) {
  const HyperbolicityReport report = Measure({{"m2", 0.815}}, kReferenceRun);
  EXPECT_EQ(report.verdict, HyperbolicityVerdict::kPseudoHyperbolic);
  for (const HyperbolicityTest& test : report.tests) {
    EXPECT_EQ(test.outcome, TestOutcome::kPassed) << test.name << ": " << test.why;
    EXPECT_GT(test.margin, 0) << test.name;
  }
  // The reference, 0.454, from an orbit of its own: minima of eighths of this orbit scatter by
  // 0.0013.
  EXPECT_NEAR(report.minimum.angle, 0.454, 0.003);
  EXPECT_GT(report.tail.index, 50);
}

TEST(Hyperbolicity, HenonMapAtM2Of085HasTangencies) {
  const HyperbolicityReport report = Measure({{"m2", 0.85}}, kReferenceRun);
  EXPECT_EQ(report.verdict, HyperbolicityVerdict::kTangencies);
  EXPECT_EQ(Find(report, "exponents").outcome, TestOutcome::kPassed);
  EXPECT_EQ(Find(report, "angle").outcome, TestOutcome::kFailed);
  EXPECT_EQ(Find(report, "lmp").outcome, TestOutcome::kFailed);
  // θ passes through 0 transversally: a tail index of one, within three standard errors.
  EXPECT_NEAR(report.tail.index, 1, 3 * report.tail.standard_error);
  // The reference is 0.0005. A minimum with such a tail is exponentially distributed: within a
  // factor of 30 of its mean nineteen times of twenty.
  EXPECT_LT(report.minimum.angle, 0.0025);
  EXPECT_LT(report.minimum_by_length[3], report.minimum_by_length[0] / 2) << "shrinking";
}

TEST(Hyperbolicity, MinimaOfLengthsAndSegmentsAgree) {
  const HyperbolicityReport report = Measure({{"m2", 0.815}}, OfLength(20000));
  double least = report.minimum_by_segment[0];
  EXPECT_EQ(report.minimum_by_length[0], least);
  for (const double minimum : report.minimum_by_segment) least = std::min(least, minimum);
  EXPECT_EQ(report.minimum_by_length[3], least);
  EXPECT_EQ(report.minimum.angle, least);
  EXPECT_EQ(report.samples, 20000 - 300);
  for (std::size_t i = 1; i < report.quantiles.size(); ++i) {
    EXPECT_LE(report.quantiles[i - 1].second, report.quantiles[i].second);
  }
}

TEST(Hyperbolicity, VolumeGrowthAveragesToTheSumOfTheFirstExponents) {
  const HyperbolicityReport report = Measure({{"m2", 0.815}}, OfLength(20000));
  const double mean = report.spectrum.per_iterate[0].value + report.spectrum.per_iterate[1].value;
  for (const double least : report.least_growth) EXPECT_LT(least, mean);
  // Over a window w the boundary terms matter like 1/w, and chance like 1/sqrt(w).
  EXPECT_LT(report.least_growth.front(), report.least_growth.back());
  EXPECT_GT(report.least_growth.back(), 0);
}

TEST(Hyperbolicity, RegularAttractorIsUndecidedWithItsFailedTest) {
  // The fixed point 0 attracts: its multipliers, λ³ = 0.5 + 0.1 λ, are less than 1 in modulus.
  const HyperbolicityReport report = Measure({{"m2", 0.1}, {"b", 0.5}}, OfLength(4000));
  EXPECT_EQ(report.verdict, HyperbolicityVerdict::kUndecided);
  EXPECT_NE(Find(report, "exponents").outcome, TestOutcome::kPassed);
}

TEST(Hyperbolicity, TooShortAnOrbitIsRefusedWithTheLengthItTakes) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  const FramedOrbit start =
      DrawStarts(Henon3dSystem().DefaultStart(), Point::Zero(3), 1, 1).front();
  const auto report = MeasureHyperbolicity(**map, start, OfLength(1000), GoOn);
  EXPECT_EQ(report.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_NE(report.status().message().find("1900"), std::string::npos) << report.status();
}

TEST(AngleHistogram, QuantilesAreGoodToHalfABin) {
  AngleHistogram histogram;
  for (int i = 1; i <= 100000; ++i) histogram.Add(1e-5 * i);
  EXPECT_NEAR(histogram.Quantile(0.5), 0.5, 0.02 * 0.5);
  EXPECT_NEAR(histogram.Quantile(0.001), 0.001, 0.04 * 0.001);
}

}  // namespace
}  // namespace celt
