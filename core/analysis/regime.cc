#include "core/analysis/regime.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace celt {
namespace {

constexpr double kSure = 3;  // standard errors

bool Positive(const Estimate& a) { return a.value > kSure * a.standard_error; }
bool Negative(const Estimate& a) { return a.value < -kSure * a.standard_error; }

/// Zero beside another exponent.
bool Zero(const Estimate& a, const Estimate& other) {
  constexpr double kSmall = 0.01;
  return !Positive(a) && !Negative(a) && kSure * a.standard_error < kSmall * std::abs(other.value);
}

}  // namespace

Regime RegimeOf(const LyapunovReport& report) {
  std::vector<Estimate> exponents = report.per_iterate;
  if (exponents.size() != 3 || report.batches < kFewestBatches) return Regime::kUnknown;
  std::sort(exponents.begin(), exponents.end(),
            [](const Estimate& a, const Estimate& b) { return a.value > b.value; });
  const Estimate& first = exponents[0];
  const Estimate& second = exponents[1];
  if (Negative(first)) return Regime::kPeriodic;
  if (Zero(first, second) && Negative(second)) return Regime::kInvariantCurve;
  if (!Positive(first)) return Regime::kUnknown;
  const bool all = std::all_of(report.conditions.begin(), report.conditions.end(),
                               [](const LyapunovCondition& condition) { return condition.holds; });
  return all ? Regime::kPseudoHyperbolicCandidate : Regime::kChaos;
}

}  // namespace celt
