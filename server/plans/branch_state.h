#pragma once

#include "absl/status/statusor.h"
#include "core/analysis/continuation.h"
#include "server/plans/state.pb.h"

namespace celt::plans {

/// Where a branch stands as a message and back, exactly: it goes on to the last bit. DATA_LOSS: the
/// message is not what was written.
BranchProgress ToProgress(const BranchState& branch);
absl::StatusOr<BranchState> FromProgress(const BranchProgress& progress);

}  // namespace celt::plans
