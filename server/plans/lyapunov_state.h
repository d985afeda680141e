#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "core/analysis/lyapunov.h"

namespace celt::plans {

/// Orbits and sums as bytes and back, exactly. DATA_LOSS: the bytes are not what was written.

std::string EncodeOrbits(std::span<const FramedOrbit> orbits);
absl::StatusOr<std::vector<FramedOrbit>> DecodeOrbits(std::string_view bytes);

std::string EncodeSums(std::span<const LyapunovSums> sums);
absl::StatusOr<std::vector<LyapunovSums>> DecodeSums(std::string_view bytes);

}  // namespace celt::plans
