#pragma once

#include "absl/status/status.h"
#include "celt/v1/job.pb.h"
#include "core/analysis/manifold.h"
#include "core/map/system.h"

namespace celt::plans {

/// Fills in and checks `spec.manifold`, when everything else is resolved.
absl::Status ResolveManifold(const System& system, v1::JobSpec& spec);

/// Of a resolved specification.
ManifoldOptions ManifoldOptionsOf(const v1::JobSpec& resolved);

}  // namespace celt::plans
