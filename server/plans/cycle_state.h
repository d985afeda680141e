#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "core/analysis/cycle.h"
#include "core/analysis/cycle_search.h"
#include "server/plans/state.pb.h"

namespace celt::plans {

/// Cycles as bytes and back, exactly. DATA_LOSS: the bytes are not what was written.

CycleState ToState(const CycleReport& cycle);
absl::StatusOr<CycleReport> FromState(const CycleState& state);

std::string EncodeSearch(const CycleSearchState& search);
absl::StatusOr<CycleSearchState> DecodeSearch(std::string_view bytes);

}  // namespace celt::plans
