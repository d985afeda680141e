#include "server/plans/lyapunov_answer.h"

#include <memory>

#include "absl/strings/str_cat.h"
#include "core/analysis/accuracy.h"
#include "core/analysis/regime.h"
#include "server/jobs/status_macros.h"
#include "server/plans/accuracy.h"

namespace celt::plans {
namespace {

using Doubles = google::protobuf::RepeatedField<double>;

void AddValues(std::span<const Estimate> estimates, Doubles* values) {
  for (const Estimate& estimate : estimates) values->Add(estimate.value);
}

void AddErrors(std::span<const Estimate> estimates, Doubles* errors) {
  for (const Estimate& estimate : estimates) errors->Add(estimate.standard_error);
}

void FillValues(const LyapunovReport& report, int orbits, v1::LyapunovResult& result) {
  AddValues(report.per_iterate, result.mutable_exponents_per_iterate());
  AddValues(report.per_time, result.mutable_exponents_per_time());
  result.set_mean_return_time(report.return_time.value);
  result.set_sum_per_iterate(report.sum_per_iterate.value);
  result.set_iterates(report.iterates);
  result.set_orbits(orbits);
  result.set_kaplan_yorke_dimension(report.kaplan_yorke_dimension);
}

void FillErrors(const LyapunovReport& report, v1::LyapunovResult& result) {
  AddErrors(report.per_iterate, result.mutable_standard_error_per_iterate());
  AddErrors(report.per_time, result.mutable_standard_error_per_time());
  result.set_standard_error_return_time(report.return_time.standard_error);
  result.set_standard_error_sum_per_iterate(report.sum_per_iterate.standard_error);
}

v1::Regime ToRegime(Regime regime) {
  switch (regime) {
    case Regime::kPeriodic:
      return v1::REGIME_PERIODIC;
    case Regime::kInvariantCurve:
      return v1::REGIME_INVARIANT_CURVE;
    case Regime::kChaos:
      return v1::REGIME_CHAOS;
    case Regime::kPseudoHyperbolicCandidate:
      return v1::REGIME_PSEUDO_HYPERBOLIC_CANDIDATE;
    case Regime::kUnknown:
      break;
  }
  return v1::REGIME_UNSPECIFIED;
}

}  // namespace

v1::Condition ToCondition(const LyapunovCondition& condition) {
  v1::Condition out;
  out.set_name(condition.name);
  out.set_holds(condition.holds);
  out.set_slack(condition.slack.value);
  if (condition.slack.standard_error > 0) out.set_margin(condition.margin);
  return out;
}

v1::LyapunovRecord ToRecord(std::span<const LyapunovSums> batches) {
  const LyapunovReport report = Summarize(batches);
  v1::LyapunovRecord record;
  record.set_iterates(report.iterates);
  AddValues(report.per_iterate, record.mutable_exponents_per_iterate());
  AddValues(report.per_time, record.mutable_exponents_per_time());
  record.set_mean_return_time(report.return_time.value);
  if (report.batches >= kFewestBatches)
    AddErrors(report.per_iterate, record.mutable_standard_error_per_iterate());
  return record;
}

v1::LyapunovResult ToResult(std::span<const LyapunovSums> batches, int orbits) {
  const LyapunovReport report = Summarize(batches);
  v1::LyapunovResult result;
  FillValues(report, orbits, result);
  if (report.batches >= kFewestBatches) FillErrors(report, result);
  for (const LyapunovCondition& condition : report.conditions) {
    *result.add_conditions() = ToCondition(condition);
  }
  result.set_regime(ToRegime(RegimeOf(report)));
  return result;
}

absl::Status AddAccuracy(const v1::JobSpec& resolved, const Map& map,
                         std::span<const FramedOrbit> sample, v1::LyapunovResult& result) {
  std::vector<Point> points;
  points.reserve(sample.size());
  for (const FramedOrbit& orbit : sample) points.push_back(orbit.point);
  v1::Accuracy& accuracy = *result.mutable_accuracy();
  CELT_ASSIGN_OR_RETURN(accuracy, MeasureAccuracy(resolved, map, points));
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<Map> better, MakeReferenceMap(resolved));
  CELT_ASSIGN_OR_RETURN(const std::vector<double> errors, ExponentErrors(map, *better, sample));
  result.mutable_map_error_per_iterate()->Add(errors.begin(), errors.end());
  for (int i = 0; i < result.standard_error_per_iterate_size(); ++i) {
    WarnIfNotBelow(absl::StrCat("lambda", i + 1), result.map_error_per_iterate(i),
                   result.standard_error_per_iterate(i), accuracy);
  }
  return absl::OkStatus();
}

}  // namespace celt::plans
