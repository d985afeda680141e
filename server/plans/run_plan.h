#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// Runs a plan from start to end in this thread and returns its result: a job within a unit of
/// another. Its records are dropped. The same bytes as when the units run anywhere else, in any
/// order. Status: the first failure in the plan's order; CANCELLED when `stop` says so.
absl::StatusOr<std::string> RunPlan(const jobs::Plan& plan, const jobs::StopRequested& stop);

}  // namespace celt::plans
