#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// The test of pseudo-hyperbolicity along one orbit, as one chain: transient, whitening, stretches.
/// The stretches show in the last digits, and are a matter of the specification.
absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeHyperbolicityPlan(const v1::JobSpec& resolved);

}  // namespace celt::plans
