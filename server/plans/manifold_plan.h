#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// The manifold of a saddle as one chain: the saddle is found, its separatrices are followed to
/// their fates, then each side is computed part by part.
absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeManifoldPlan(const v1::JobSpec& resolved);

}  // namespace celt::plans
