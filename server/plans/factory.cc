#include "server/plans/factory.h"

#include "celt/v1/job.pb.h"
#include "server/jobs/status_macros.h"
#include "server/plans/analysis.h"

namespace celt::plans {

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakePlan(std::string_view specification) {
  v1::JobSpec spec;
  if (!spec.ParseFromArray(specification.data(), static_cast<int>(specification.size()))) {
    return absl::DataLossError("the stored specification is damaged");
  }
  CELT_ASSIGN_OR_RETURN(const Analysis analysis, FindAnalysis(spec));
  return analysis.make_plan(spec);
}

}  // namespace celt::plans
