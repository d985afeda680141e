#include "server/plans/limits.h"

#include <cstdint>
#include <string>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/chosen.h"

namespace celt::plans {
namespace {

absl::Status Check(const std::string& field, const char* what, double value, std::int64_t limit) {
  if (value <= static_cast<double>(limit)) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(field, ": ", value, " ", what, " are more than this server's ", limit));
}

absl::Status CheckSweep(const v1::SweepSpec& sweep, const SpecLimits& limits) {
  double nodes = 1;
  for (const v1::Axis& axis : sweep.axes()) nodes *= axis.nodes();
  CELT_RETURN_IF_ERROR(Check("sweep.axes", "nodes", nodes, limits.nodes));
  CELT_RETURN_IF_ERROR(Check("sweep.axes", "records", nodes, limits.records));
  const Chosen node = AnalysisOf(sweep);
  if (node.analysis == nullptr) return absl::OkStatus();
  return Check(absl::StrCat("sweep.", node.name, ".iterates"), "iterates at all nodes",
               nodes * Iterates(*node.analysis), limits.iterates);
}

}  // namespace

absl::Status CheckLimits(const v1::JobSpec& resolved, const SpecLimits& limits) {
  if (resolved.has_sweep()) return CheckSweep(resolved.sweep(), limits);
  const Chosen chosen = AnalysisOf(resolved);
  if (chosen.analysis == nullptr) return absl::OkStatus();
  const auto field = [&](const char* name) { return absl::StrCat(chosen.name, ".", name); };
  CELT_RETURN_IF_ERROR(
      Check(field("iterates"), "iterates", Iterates(*chosen.analysis), limits.iterates));
  if (resolved.has_section()) {
    const auto records = static_cast<double>(resolved.section().iterates());
    CELT_RETURN_IF_ERROR(Check("section.iterates", "records", records, limits.records));
  }
  if (resolved.has_orbit()) {
    const double records = resolved.orbit().time() / resolved.orbit().step();
    CELT_RETURN_IF_ERROR(Check("orbit.step", "records", records, limits.records));
  }
  return Check(field("most_points"), "points", Count(*chosen.analysis, "most_points"),
               limits.records);
}

}  // namespace celt::plans
