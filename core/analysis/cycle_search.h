#pragma once

#include <cstdint>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/statusor.h"
#include "core/analysis/cycle.h"
#include "core/map/map.h"

namespace celt {

/// Where, and for what, a search draws its starts.
struct CycleSearchOptions {
  int period = 1;
  Point lower;             ///< corner of the box that starts are drawn from
  Point upper;             ///< the opposite corner, nowhere below `lower`
  std::uint64_t seed = 1;  ///< the same seed gives the same starts on every machine
  /// Cycles all of whose points are closer than this are one.
  double same_distance = 1e-6;
  NewtonOptions newton;
};

/// A cycle that a search found, once however often it or one of its twins was met. Twins are its
/// images under the map's symmetries that do not reverse time; of them the one reported has the
/// least first coordinate (then second, …) of its points, and starts there.
struct FoundCycle {
  CycleReport cycle;
  std::int64_t first_start = 0;  ///< the least index of a start that led to it or to a twin
  std::int64_t hits = 0;         ///< starts that did
  int twins = 0;                 ///< images under the symmetries that are other cycles
};

/// How the starts ended. The counts after `starts` add up to it.
struct CycleSearchTally {
  std::int64_t starts = 0;
  std::int64_t found = 0;           ///< a cycle of the period asked for
  std::int64_t shorter = 0;         ///< a cycle whose period is a proper divisor
  std::int64_t no_convergence = 0;  ///< as of CycleTermination
  std::int64_t left_domain = 0;
  std::int64_t singular = 0;
  std::int64_t outside = 0;  ///< the start is no point of the map's domain
};

/// Plain data: what a range of starts led to. Cycles come in the order of their first starts.
struct CycleSearchState {
  std::vector<FoundCycle> cycles;
  CycleSearchTally tally;
};

/// Called after each start; false stops (CANCELLED).
using SearchTick = absl::FunctionRef<bool()>;

/// Newton's method (FindCycle) from the starts with indices first, …, last − 1, each drawn on its
/// own from seed and index. Pure; safe from many threads. INVALID_ARGUMENT names an option out of
/// its range; a start that leads nowhere is counted, not an error.
absl::StatusOr<CycleSearchState> SearchCycles(const Map& map, const CycleSearchOptions& options,
                                              std::int64_t first, std::int64_t last,
                                              SearchTick tick);

/// Adds what later starts led to. Merging the pieces of a range in order gives what searching it
/// whole does, to the last bit.
void Merge(const Map& map, const CycleSearchOptions& options, const CycleSearchState& later,
           CycleSearchState& state);

/// For each cycle the index of the one that a symmetry that reverses time takes it to (up to
/// twins), possibly its own; −1 when that one is not among them or there is no such symmetry.
std::vector<int> MirrorIndices(const Map& map, const CycleSearchOptions& options,
                               const std::vector<FoundCycle>& cycles);

/// Adds the mirror images that are not among the cycles: each is known to exist, is corrected by
/// FindCycle and has no hits and −1 for its first start. One that does not converge is left out.
void AddMirrors(const Map& map, const CycleSearchOptions& options, CycleSearchState& state);

/// Start number `index`: uniform in the box.
Point DrawStart(const CycleSearchOptions& options, std::int64_t index);

/// INVALID_ARGUMENT names the option out of range.
absl::Status CheckCycleSearch(const Map& map, const CycleSearchOptions& options);

}  // namespace celt
