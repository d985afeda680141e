#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/statusor.h"
#include "core/analysis/cycle.h"
#include "core/analysis/saddle.h"
#include "core/map/map.h"
#include "core/map/map_family.h"

namespace celt {

/// What became of an orbit that left a saddle along its one-dimensional manifold.
enum class SeparatrixEnd {
  kTendsToCycle,  ///< it came to rest under G, at a cycle of the map
  kWanders,       ///< it changed sides twice
  kUndecided,     ///< neither, within the iterates allowed
  kLost,          ///< it left the domain
};

/// The fate of a separatrix under G, the map's iterates that keep the sides of the manifold (F² for
/// a saddle fixed point with a negative multiplier). Sides are those of the saddle's other manifold
/// W^ss or W^s, taken for its tangent plane: a point counts as on a side when its distance from
/// that plane is more than a fifth of the largest so far.
struct SeparatrixFate {
  SeparatrixEnd end = SeparatrixEnd::kUndecided;
  int side = 0;               ///< where it was last: +1 or −1
  int changes = 0;            ///< of side; none: it never left the side where it started
  std::int64_t iterates = 0;  ///< of G
  Point point;                ///< where it was last
  std::string message;        ///< of kLost
};

struct SeparatrixOptions {
  int side = 1;  ///< on which it starts: ±1
  /// Distance from the saddle at which it starts, along the tangent; it also must have been a
  /// thousand times as far away before anything is decided.
  double step = 1e-6;
  std::int64_t most_iterates = 20'000;  ///< of G
  /// It tends to a cycle when G moves it by less than this. Spiralling in at a rate ρ per iterate
  /// it is then some tolerance/(1 − ρ) away: to be small against the cycle's own basin.
  double tolerance = 1e-6;
};

/// Follows a separatrix. INVALID_ARGUMENT names an option out of range; CANCELLED: `tick`, called
/// with each iterate of G, said so. An orbit that is lost is a fate, not a failure.
absl::StatusOr<SeparatrixFate> FollowSeparatrix(
    const Map& map, const Saddle& saddle, const SeparatrixOptions& options,
    absl::FunctionRef<bool(std::int64_t iterates)> tick);

/// What is asked about the separatrix at each value of a parameter.
enum class SeparatrixQuestion {
  kReturnsToItsSide,  ///< it comes back on the side where it started: switches at a butterfly
  kTendsToCycle,      ///< it ends at a cycle: switches where it leaves that cycle's basin
};

struct SeparatrixSearch {
  double from = 0;  ///< ends of the interval; the answers there must differ
  double to = 0;
  double width = 1e-7;  ///< of the bracket that is asked for, > 0
  Point guess;          ///< of a saddle of `period`, at `from`
  int period = 1;
  SeparatrixQuestion question = SeparatrixQuestion::kReturnsToItsSide;
  SeparatrixOptions options;
};

/// A value of the parameter that was looked at.
struct SeparatrixProbe {
  double value = 0;
  Point saddle;      ///< there
  int iterates = 1;  ///< of the map in one of G
  SeparatrixFate fate;
  bool answer = false;  ///< to the question
};

/// Where a bisection stands: plain data, from which it can be resumed.
struct SeparatrixBisection {
  /// What was found at the ends of the bracket: none, then that at `from`, then both, which differ
  /// in their answers.
  std::vector<SeparatrixProbe> ends;
  SeparatrixProbe last;  ///< the last value looked at
  bool done = false;     ///< the bracket is as narrow as was asked for, or as doubles allow
};

/// Looks at one more value: the ends first, then the middle of the bracket. The saddle is carried
/// along by Newton's method.
///
/// Where the answer is kTendsToCycle, an undecided fate counts as no: near the switch orbits take
/// ever longer to decide, and the bracket's reliable width is told by which fates are undecided.
///
/// INVALID_ARGUMENT: an option out of range; no saddle with a one-dimensional unstable manifold;
/// answers at the ends that do not differ (`last` is set, the message has both fates). NOT_FOUND:
/// no cycle at that value. CANCELLED: `tick` said so. Precondition: not done.
absl::Status StepBisection(const MapFamily& family, const SeparatrixSearch& search,
                           SeparatrixBisection& bisection,
                           absl::FunctionRef<bool(std::int64_t iterates)> tick);

struct SeparatrixBracket {
  double yes = 0;  ///< the last value of the parameter at which the answer was yes
  double no = 0;
  Point saddle;  ///< at the last value looked at
  SeparatrixFate yes_fate;
  SeparatrixFate no_fate;
};

/// Precondition: the bisection has both ends.
SeparatrixBracket BracketOf(const SeparatrixBisection& bisection);

/// Halves an interval of the parameter until it is narrow: StepBisection until it is done.
absl::StatusOr<SeparatrixBracket> BisectSeparatrix(
    const MapFamily& family, const SeparatrixSearch& search,
    absl::FunctionRef<bool(std::int64_t iterates)> tick);

/// "tends to a cycle", "wanders", "undecided", "lost".
const char* Name(SeparatrixEnd end);

}  // namespace celt
