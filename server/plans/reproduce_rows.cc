#include "server/plans/reproduce_rows.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_format.h"
#include "server/jobs/status_macros.h"
#include "server/plans/analysis.h"
#include "server/plans/run_plan.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::plans {

v1::JobSpec Reproduction::At(double energy) const {
  v1::JobSpec spec;
  *spec.mutable_system() = base_.system();
  // Each kind of job has a tolerance of its own.
  spec.mutable_numerics()->set_engine(base_.numerics().engine());
  spec.set_frame(base_.frame());
  (*spec.mutable_system()->mutable_parameters())["energy"] = energy;
  return spec;
}

absl::StatusOr<v1::Result> Reproduction::Run(const v1::JobSpec& spec) const {
  CELT_ASSIGN_OR_RETURN(const v1::JobSpec resolved, ResolveSpec(spec));
  CELT_ASSIGN_OR_RETURN(const Analysis analysis, FindAnalysis(resolved));
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<jobs::Plan> plan, analysis.make_plan(resolved));
  CELT_ASSIGN_OR_RETURN(const std::string result, RunPlan(*plan, stop_));
  return Parse<v1::Result>(result);
}

std::string Digits(double value, double error) {
  constexpr int kMostDecimals = 10;
  const int decimals =
      error > 0 ? static_cast<int>(std::ceil(1 - std::log10(error))) : kMostDecimals;
  return absl::StrFormat("%.*f", std::clamp(decimals, 0, kMostDecimals), value);
}

v1::ReproduceRecord MakeRow(const NumberRow& row) {
  v1::ReproduceRecord record;
  record.set_section(row.section);
  record.set_quantity(row.quantity);
  record.set_paper(row.paper);
  record.set_computed(Digits(row.computed, row.error));
  if (row.error > 0) record.set_error(row.error);
  const bool agrees = std::abs(row.computed - row.printed) <= row.printed_error + 3 * row.error;
  record.set_verdict(agrees ? v1::AGREES : v1::DIFFERS);
  record.set_remark(row.remark);
  record.add_values(row.computed);
  return record;
}

v1::ReproduceRecord MakeRow(const StatementRow& row) {
  v1::ReproduceRecord record;
  record.set_section(row.section);
  record.set_quantity(row.quantity);
  record.set_paper(row.paper);
  record.set_computed(row.computed);
  record.set_verdict(row.holds ? v1::HOLDS : v1::FAILS);
  record.set_remark(row.remark);
  return record;
}

}  // namespace celt::plans
