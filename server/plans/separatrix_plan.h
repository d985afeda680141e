#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// The plan of a resolved specification: one chain, a value of the parameter a unit.
absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeSeparatrixPlan(const v1::JobSpec& resolved);

}  // namespace celt::plans
