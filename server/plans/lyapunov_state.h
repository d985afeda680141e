#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "core/analysis/lyapunov.h"

namespace celt::plans {

/// Orbits and tallies as bytes and back, exactly. DATA_LOSS: the bytes are not what was written.

std::string EncodeOrbits(std::span<const FramedOrbit> orbits);
absl::StatusOr<std::vector<FramedOrbit>> DecodeOrbits(std::string_view bytes);

/// What units gather for the fold, and what the fold has gathered.
struct LyapunovTally {
  std::vector<LyapunovSums> sums;
  std::vector<FramedOrbit> sample;
};

std::string EncodeTally(const LyapunovTally& tally);
absl::StatusOr<LyapunovTally> DecodeTally(std::string_view bytes);

}  // namespace celt::plans
