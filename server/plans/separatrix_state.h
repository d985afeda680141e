#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "core/analysis/separatrix.h"

namespace celt::plans {

/// A bisection as bytes and back, exactly; no bytes are one that has not begun. DATA_LOSS: the
/// bytes are not what was written.
std::string EncodeBisection(const SeparatrixBisection& bisection);
absl::StatusOr<SeparatrixBisection> DecodeBisection(std::string_view bytes);

}  // namespace celt::plans
