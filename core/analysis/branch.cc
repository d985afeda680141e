#include "core/analysis/branch.h"

#include <iterator>
#include <utility>

#include "absl/status/status.h"

namespace celt {

absl::StatusOr<BranchStretch> AdvanceBranch(const MapFamily& family,
                                            const ContinuationOptions& options, BranchState& state,
                                            std::int64_t most_points, BranchTick tick) {
  BranchStretch stretch;
  while (state.end == BranchEnd::kNone && std::ssize(stretch.points) < most_points) {
    const BranchPoint before = state.point;
    const std::int64_t points = state.points;
    StepBranch(family, options, state);
    if (state.points == points) break;
    auto met = LocateBifurcations(family, options, before, state.point);
    if (!met.ok()) return met.status();
    std::move(met->begin(), met->end(), std::back_inserter(stretch.bifurcations));
    stretch.points.push_back(state.point);
    if (!tick()) return absl::CancelledError("stopped before the branch was done");
  }
  return stretch;
}

}  // namespace celt
