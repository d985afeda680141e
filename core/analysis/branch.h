#pragma once

#include <cstdint>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/statusor.h"
#include "core/analysis/bifurcation.h"
#include "core/analysis/continuation.h"
#include "core/map/map_family.h"

namespace celt {

/// A stretch of a branch: its new points, in the order of travel, and what happened on the way to
/// each of them, that from the point before the stretch included.
struct BranchStretch {
  std::vector<BranchPoint> points;
  std::vector<Bifurcation> bifurcations;
};

/// Called after each point; false stops (CANCELLED).
using BranchTick = absl::FunctionRef<bool()>;

/// Follows a branch for up to `most_points` points or to its end, whichever comes first, and
/// locates the bifurcations. Where a branch is cut into stretches makes no difference. Pure.
absl::StatusOr<BranchStretch> AdvanceBranch(const MapFamily& family,
                                            const ContinuationOptions& options, BranchState& state,
                                            std::int64_t most_points, BranchTick tick);

}  // namespace celt
