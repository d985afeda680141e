#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/analysis/cycle_search.h"
#include "core/map/system.h"

namespace celt::plans {

/// Fills in and checks `spec.fixed_point`, when everything else is resolved.
absl::Status ResolveFixedPoint(const System& system, v1::JobSpec& spec);

/// Of a resolved specification.
NewtonOptions NewtonOf(const v1::FixedPointSpec& spec);

/// Of a resolved specification with a search. The box is given in the frame of the job, searched in
/// the map's own coordinates.
absl::StatusOr<CycleSearchOptions> SearchOf(const v1::JobSpec& resolved);

}  // namespace celt::plans
