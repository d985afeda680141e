#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// An orbit of the stone's flow as one chain. A unit starts the integrator anew: where the cuts are
/// is a matter of the specification, for they show in the last digits.
absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeOrbitPlan(const v1::JobSpec& resolved);

}  // namespace celt::plans
