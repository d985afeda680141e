#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// The plan of a resolved specification: one chain, branch after branch.
absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeContinuationPlan(const v1::JobSpec& resolved);

}  // namespace celt::plans
