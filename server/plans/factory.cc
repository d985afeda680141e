#include "server/plans/factory.h"

#include "celt/v1/job.pb.h"
#include "server/jobs/status_macros.h"
#include "server/plans/lyapunov_plan.h"

namespace celt::plans {

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakePlan(std::string_view specification) {
  v1::JobSpec spec;
  if (!spec.ParseFromArray(specification.data(), static_cast<int>(specification.size()))) {
    return absl::DataLossError("the stored specification is damaged");
  }
  switch (spec.analysis_case()) {
    case v1::JobSpec::kLyapunov:
      return LyapunovPlan::Make(spec);
    case v1::JobSpec::ANALYSIS_NOT_SET:
      break;
  }
  return absl::InvalidArgumentError("analysis: missing, or of a newer celt");
}

}  // namespace celt::plans
