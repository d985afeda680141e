#include "core/analysis/hyperbolicity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace celt {
namespace {

constexpr std::int64_t kLeastBlocks = 16;
constexpr int kMostTail = 32;
constexpr double kLonger = 100;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The least of all block minima from `first` (inclusive) to `last` eighths of the orbit.
double MinimumOfEighths(const std::vector<double>& minima, std::size_t first, std::size_t last) {
  const std::size_t n = minima.size();
  double least = kInfinity;
  for (std::size_t i = n * first / 8; i < n * last / 8; ++i) least = std::min(least, minima[i]);
  return least;
}

/// Hill's estimator over the least eighth of the block minima, 32 at most.
AngleTail TailOf(std::vector<double> minima) {
  std::sort(minima.begin(), minima.end());
  AngleTail tail;
  tail.blocks = static_cast<int>(
      std::clamp<std::size_t>(minima.size() / 8, std::size_t{4}, std::size_t{kMostTail}));
  double sum = 0;
  for (int i = 0; i < tail.blocks; ++i) sum += std::log(minima[tail.blocks] / minima[i]);
  tail.index = sum > 0 ? tail.blocks / sum : kInfinity;
  tail.standard_error = tail.index / std::sqrt(tail.blocks);
  tail.promised_minimum = minima.front() * std::pow(kLonger, -1 / tail.index);
  return tail;
}

/// The outcome of a value that passes above one limit and fails below another.
HyperbolicityTest Above(const char* name, double value, double pass, double fail) {
  HyperbolicityTest test = {.name = name,
                            .outcome = TestOutcome::kOpen,
                            .value = value,
                            .pass_limit = pass,
                            .fail_limit = fail,
                            .margin = value - pass,
                            .why = ""};
  if (value > pass) test.outcome = TestOutcome::kPassed;
  if (value < fail) test.outcome = TestOutcome::kFailed;
  return test;
}

HyperbolicityTest TestExponents(const LyapunovReport& spectrum) {
  double least = kInfinity;
  const char* name = "";
  for (const LyapunovCondition& condition : spectrum.conditions) {
    if (condition.margin < least) {
      least = condition.margin;
      name = condition.name;
    }
  }
  if (spectrum.conditions.empty()) least = 0;
  HyperbolicityTest test = Above("exponents", least, 2, -2);
  test.why = spectrum.conditions.empty()
                 ? "the conditions are on maps of dimension 3"
                 : absl::StrCat(name, " by ", least, " standard errors, the least of all");
  return test;
}

HyperbolicityTest TestSettled(double disagreement) {
  constexpr double kEnough = 1e-6;
  HyperbolicityTest test = Above("settled", -disagreement, -kEnough, -kEnough);
  test.value = disagreement;
  test.pass_limit = test.fail_limit = kEnough;
  test.why = absl::StrCat("two pull-backs to E^ss differ by at most ", disagreement, " rad");
  return test;
}

HyperbolicityTest TestAngle(const HyperbolicityReport& report, double median) {
  const double promised = report.tail.promised_minimum;
  HyperbolicityTest test = Above("angle", promised, median / 10, median / 100);
  test.margin = std::log10(promised / test.pass_limit);
  const bool ends = std::isinf(report.tail.index);
  test.why = absl::StrCat("minimum ", report.minimum.angle, " rad, tail index ",
                          ends ? "beyond measure" : absl::StrCat(report.tail.index), ": a ",
                          kLonger, " times longer orbit promises ", promised, " rad");
  return test;
}

HyperbolicityTest TestLmp(const std::vector<LmpBin>& graph) {
  constexpr double kContinuous = 0.2;
  constexpr double kTorn = 0.5;
  constexpr std::int64_t kLeastPairs = 100;
  const LmpNear near = NearestPairs(graph, kLmpNear);
  HyperbolicityTest test = Above("lmp", -near.widest.angle, -kContinuous, -kTorn);
  test.value = near.widest.angle;
  test.pass_limit = kContinuous;
  test.fail_limit = kTorn;
  if (near.pairs < kLeastPairs && test.outcome == TestOutcome::kPassed) {
    test.outcome = TestOutcome::kOpen;
  }
  test.why = absl::StrCat(near.pairs, " pairs closer than ", kLmpNear,
                          " standard deviations; the widest, ", near.widest.distance,
                          " apart, differ by ", near.widest.angle, " rad");
  return test;
}

HyperbolicityTest TestGrowth(const HyperbolicityReport& report) {
  std::size_t best = 0;
  for (std::size_t i = 0; i < kGrowthWindows.size(); ++i) {
    const bool known = report.least_growth[i] < kInfinity;
    if (known && report.least_growth[i] > report.least_growth[best]) best = i;
  }
  HyperbolicityTest test = Above("growth", report.least_growth[best], 0, -kInfinity);
  test.why = absl::StrCat("volume on E^cu grows by at least exp(", report.least_growth[best],
                          ") an iterate over any ", kGrowthWindows[best], " iterates");
  return test;
}

HyperbolicityVerdict Conclude(const std::vector<HyperbolicityTest>& tests) {
  const auto outcome = [&tests](std::size_t i) { return tests[i].outcome; };
  const bool all = std::all_of(tests.begin(), tests.end(), [](const HyperbolicityTest& test) {
    return test.outcome == TestOutcome::kPassed;
  });
  if (all) return HyperbolicityVerdict::kPseudoHyperbolic;
  const bool meaningful = outcome(0) != TestOutcome::kFailed && outcome(1) == TestOutcome::kPassed;
  const bool torn = outcome(2) == TestOutcome::kFailed || outcome(3) == TestOutcome::kFailed;
  return meaningful && torn ? HyperbolicityVerdict::kTangencies : HyperbolicityVerdict::kUndecided;
}

/// The statistics of the angles alone.
HyperbolicityReport DescribeAngles(const HyperbolicitySums& sums) {
  HyperbolicityReport report;
  report.samples = sums.samples;
  report.minimum = sums.closest;
  for (const double fraction : {0.001, 0.01, 0.05, 0.1, 0.25, 0.5, 0.75, 0.9}) {
    report.quantiles.emplace_back(fraction, sums.angles.Quantile(fraction));
  }
  for (std::size_t i = 0; i < 4; ++i) {  // 1, 2, 4, 8 eighths
    report.minimum_by_length[i] = MinimumOfEighths(sums.block_minima, 0, std::size_t{1} << i);
  }
  for (std::size_t i = 0; i < 8; ++i) {
    report.minimum_by_segment[i] = MinimumOfEighths(sums.block_minima, i, i + 1);
  }
  return report;
}

absl::Status CheckRun(const HyperbolicityRun& run) {
  if (run.transient >= 0 && run.scout >= 2 && run.iterates >= 1 && run.stretch >= 1) {
    return absl::OkStatus();
  }
  return absl::InvalidArgumentError(absl::StrCat(
      "transient: ", run.transient, ", scout: ", run.scout, ", iterates: ", run.iterates,
      ", stretch: ", run.stretch, "; must be at least 0, 2, 1, 1"));
}

}  // namespace

std::int64_t LeastIterates(const HyperbolicityOptions& options) {
  return kLeastBlocks * options.block + options.settle;
}

absl::StatusOr<HyperbolicityReport> JudgeHyperbolicity(const HyperbolicitySums& sums,
                                                       const HyperbolicityOptions& options,
                                                       const LmpOptions& lmp) {
  if (std::ssize(sums.block_minima) < kLeastBlocks) {
    return absl::InvalidArgumentError(
        absl::StrCat("iterates: ", sums.samples + options.settle, " is not allowed; at least ",
                     LeastIterates(options), " are needed for a verdict"));
  }
  HyperbolicityReport report = DescribeAngles(sums);
  report.spectrum = Summarize(sums.batches);
  report.tail = TailOf(sums.block_minima);
  report.least_growth = sums.least_growth;
  report.lmp_graph = LmpGraph(sums.lmp_points, lmp);
  report.disagreement = sums.disagreement;
  report.tests = {TestExponents(report.spectrum), TestSettled(report.disagreement),
                  TestAngle(report, sums.angles.Quantile(0.5)), TestLmp(report.lmp_graph),
                  TestGrowth(report)};
  report.verdict = Conclude(report.tests);
  return report;
}

absl::StatusOr<HyperbolicityReport> MeasureHyperbolicity(const Map& map, FramedOrbit start,
                                                         const HyperbolicityRun& run,
                                                         LyapunovTick tick) {
  absl::Status status = CheckRun(run);
  if (!status.ok()) return status;
  if (auto sums = AdvanceFrames(map, {&start, 1}, run.transient, tick); !sums.ok()) {
    return sums.status();
  }
  CovarianceSums covariance;
  status = AdvanceCovariance(map, start, run.scout, tick, covariance);
  if (!status.ok()) return status;
  const Whitening whitening = WhiteningOf(covariance);
  SplittingOrbit orbit = {.orbit = std::move(start), .iterates = 0, .pending = {}};
  HyperbolicitySums sums;
  while (orbit.iterates < run.iterates) {
    const auto stretch = AdvanceSplitting(
        map, orbit, std::min(run.stretch, run.iterates - orbit.iterates), run.options.settle, tick);
    if (!stretch.ok()) return stretch.status();
    AddStretch(map, whitening, run.options, *stretch, sums);
  }
  return JudgeHyperbolicity(sums, run.options);
}

}  // namespace celt
