#include "server/plans/hyperbolicity_answer.h"

#include <cmath>

#include "server/plans/lyapunov_answer.h"

namespace celt::plans {
namespace {

v1::HyperbolicityVerdict ToVerdict(HyperbolicityVerdict verdict) {
  switch (verdict) {
    case HyperbolicityVerdict::kPseudoHyperbolic:
      return v1::PSEUDO_HYPERBOLIC;
    case HyperbolicityVerdict::kTangencies:
      return v1::TANGENCIES;
    case HyperbolicityVerdict::kUndecided:
      break;
  }
  return v1::UNDECIDED;
}

const char* Name(TestOutcome outcome) {
  switch (outcome) {
    case TestOutcome::kPassed:
      return "passed";
    case TestOutcome::kFailed:
      return "failed";
    case TestOutcome::kOpen:
      break;
  }
  return "open";
}

void FillTests(const HyperbolicityReport& report, v1::HyperbolicityResult& result) {
  for (const HyperbolicityTest& test : report.tests) {
    v1::HyperbolicityTest& out = *result.add_tests();
    out.set_name(test.name);
    out.set_outcome(Name(test.outcome));
    if (std::isfinite(test.value)) out.set_value(test.value);
    if (std::isfinite(test.margin)) out.set_margin(test.margin);
    out.set_why(test.why);
  }
}

void FillAngles(const HyperbolicityReport& report, const PointFrame& frame,
                v1::HyperbolicityResult& result) {
  result.set_minimum_angle(report.minimum.angle);
  *result.mutable_minimum_point() = frame.FromPoint(report.minimum.point);
  for (const double angle : report.minimum_by_length) result.add_minimum_by_length(angle);
  for (const double angle : report.minimum_by_segment) result.add_minimum_by_segment(angle);
  for (const auto& [fraction, angle] : report.quantiles) {
    v1::AngleQuantile& quantile = *result.add_quantiles();
    quantile.set_fraction(fraction);
    quantile.set_angle(angle);
  }
  if (std::isfinite(report.tail.index)) result.set_tail_index(report.tail.index);
  if (std::isfinite(report.tail.promised_minimum)) {
    result.set_promised_minimum(report.tail.promised_minimum);
  }
}

void FillSpectrum(const LyapunovReport& spectrum, v1::HyperbolicityResult& result) {
  for (const Estimate& exponent : spectrum.per_iterate) {
    result.add_exponents_per_iterate(exponent.value);
    result.add_standard_error_per_iterate(exponent.standard_error);
  }
  for (const LyapunovCondition& condition : spectrum.conditions) {
    *result.add_conditions() = ToCondition(condition);
  }
}

/// Only windows that fit into the orbit.
void FillGrowth(const HyperbolicityReport& report, v1::HyperbolicityResult& result) {
  for (std::size_t i = 0; i < kGrowthWindows.size(); ++i) {
    if (!std::isfinite(report.least_growth[i])) continue;
    result.add_growth_windows(kGrowthWindows[i]);
    result.add_least_growth(report.least_growth[i]);
  }
}

void FillLmp(const HyperbolicityReport& report, v1::HyperbolicityResult& result) {
  for (const LmpBin& bin : report.lmp_graph) {
    v1::LmpBin& out = *result.add_lmp_graph();
    out.set_from(bin.from);
    out.set_to(bin.to);
    out.set_complete(bin.complete);
    out.set_pairs(bin.pairs);
    if (bin.pairs > 0) out.set_largest_angle(bin.widest.angle);
    for (const LmpPair& pair : bin.sample) {
      v1::LmpPair& drawn = *out.add_sample();
      drawn.set_distance(pair.distance);
      drawn.set_angle(pair.angle);
    }
  }
}

}  // namespace

v1::HyperbolicityResult ToResult(const HyperbolicityReport& report, const PointFrame& frame) {
  v1::HyperbolicityResult result;
  result.set_verdict(ToVerdict(report.verdict));
  FillTests(report, result);
  FillSpectrum(report.spectrum, result);
  FillAngles(report, frame, result);
  FillGrowth(report, result);
  FillLmp(report, result);
  result.set_samples(report.samples);
  return result;
}

}  // namespace celt::plans
