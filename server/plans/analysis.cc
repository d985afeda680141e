#include "server/plans/analysis.h"

#include "server/plans/lyapunov_plan.h"
#include "server/plans/lyapunov_spec.h"

namespace celt::plans {

absl::StatusOr<Analysis> FindAnalysis(const v1::JobSpec& spec) {
  switch (spec.analysis_case()) {
    case v1::JobSpec::kLyapunov:
      return Analysis{ResolveLyapunov, MakeLyapunovPlan};
    default:
      return absl::InvalidArgumentError("analysis: missing, or not known here; set lyapunov");
  }
}

}  // namespace celt::plans
