#pragma once

#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/analysis/lyapunov.h"
#include "core/map/system.h"

namespace celt::plans {

/// Fills in and checks `spec.lyapunov`, when everything else is resolved: its numbers, and that all
/// starts lie in the map's domain.
absl::Status ResolveLyapunov(const System& system, v1::JobSpec& spec);

/// The starts of all orbits of a resolved specification.
absl::StatusOr<std::vector<FramedOrbit>> LyapunovStarts(const v1::JobSpec& resolved);

}  // namespace celt::plans
