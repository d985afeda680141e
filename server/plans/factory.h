#pragma once

#include <memory>
#include <string_view>

#include "absl/status/statusor.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// The plan of a resolved specification (celt.v1.JobSpec, serialized): a jobs::PlanFactory.
absl::StatusOr<std::unique_ptr<jobs::Plan>> MakePlan(std::string_view specification);

}  // namespace celt::plans
