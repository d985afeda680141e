#include "server/plans/lyapunov_answer.h"

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

void FillCondition(const LyapunovCondition& from, v1::Condition& to) {
  to.set_name(from.name);
  to.set_holds(from.holds);
  to.set_slack(from.slack.value);
  if (from.slack.standard_error > 0) to.set_margin(from.margin);
}

}  // namespace

v1::LyapunovRecord ToRecord(std::span<const LyapunovSums> batches,
                            std::span<const LyapunovSums> complete) {
  const LyapunovReport report = Summarize(batches);
  v1::LyapunovRecord record;
  record.set_iterates(report.iterates);
  AddValues(report.per_iterate, record.mutable_exponents_per_iterate());
  AddValues(report.per_time, record.mutable_exponents_per_time());
  record.set_mean_return_time(report.return_time.value);
  if (complete.size() > 1) {
    AddErrors(Summarize(complete).per_iterate, record.mutable_standard_error_per_iterate());
  }
  return record;
}

v1::LyapunovResult ToResult(std::span<const LyapunovSums> batches, int orbits) {
  const LyapunovReport report = Summarize(batches);
  v1::LyapunovResult result;
  FillValues(report, orbits, result);
  // One batch alone says nothing of its error.
  if (batches.size() > 1) FillErrors(report, result);
  for (const LyapunovCondition& condition : report.conditions) {
    FillCondition(condition, *result.add_conditions());
  }
  return result;
}

}  // namespace celt::plans
