#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/analysis/orbit.h"
#include "core/map/system.h"

namespace celt::plans {

/// Fills in and checks `spec.orbit`, when everything else is resolved. What it does to the rest of
/// the specification: a job that starts from a state has that state's energy, and an engine that
/// goes from section to section only gives way to ARKODE.
absl::Status ResolveOrbit(const System& system, v1::JobSpec& spec);

/// Of a resolved specification.
absl::StatusOr<StoneOrbit> OrbitStart(const CelticStone& stone, const v1::JobSpec& resolved);
absl::StatusOr<OrbitOptions> ToOrbitOptions(const v1::OrbitSpec& resolved);
CelticStone StoneOf(const v1::JobSpec& resolved);

}  // namespace celt::plans
