#pragma once

#include <cstdint>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "core/map/map.h"

namespace celt {

/// Where an orbit of a map is: all that is needed to go on with it.
struct SectionOrbit {
  Point point;
  std::int64_t iterate = 0;  ///< from the start; negative when going backward
  double time = 0;  ///< of the underlying flow, from the start; negative when going backward
};

/// An iterate.
struct SectionRecord {
  SectionOrbit at;
  double return_time = 0;  ///< that the last iterate took, positive in both directions
};

/// Called with each iterate; false stops the orbit there (CANCELLED).
using SectionVisit = absl::FunctionRef<bool(const SectionRecord& record)>;

/// Advances an orbit by `iterates` of the map or of its inverse, chunk by chunk as it suits: how
/// it is cut changes nothing. A transient is a call whose iterates nobody keeps.
///
/// Status as of Map::Apply; `orbit` is then where it was last, and the iterates up to there have
/// been visited. Precondition: iterates ≥ 0.
absl::Status AdvanceSection(const Map& map, SectionOrbit& orbit, std::int64_t iterates,
                            Direction direction, SectionVisit visit);

}  // namespace celt
