#pragma once

#include "absl/status/statusor.h"
#include "core/analysis/bifurcation.h"
#include "core/analysis/continuation.h"
#include "core/map/map_family.h"

namespace celt {

/// The beginning of the branch of doubled cycles that leaves a period doubling: a first point close
/// by, to be followed by StepBranch. In the space of cycles gone round twice that branch is tangent
/// to (v, −v, 0), v = (q, DF q, …) carried along the cycle from the eigenvector q of DF^k at −1
/// (Kuznetsov 2004, §10.2.2); the point is found by correcting in the hyperplane across that
/// tangent, at the first distance of initial_step, initial_step/2, … from which it can be and at
/// which the branch has turned by no more than most_turn. Its tangent points away from the
/// bifurcation. The branch ends where the parameter leaves
/// [from, to] at either end.
///
/// The state has no points and an end that says why when no such point was found. INVALID_ARGUMENT:
/// the bifurcation is no period doubling, its double period is longer than kLongestPeriod, or an
/// option is out of its range. Pure.
absl::StatusOr<BranchState> SwitchToDoubled(const MapFamily& family,
                                            const ContinuationOptions& options,
                                            const Bifurcation& doubling);

}  // namespace celt
