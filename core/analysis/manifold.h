#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "core/analysis/saddle.h"
#include "core/map/map.h"

namespace celt {

/// How finely a manifold is resolved, and how far it is followed.
struct ManifoldOptions {
  double length = 1;           ///< arc length of each side, > 0
  double most_spacing = 0.01;  ///< between neighbouring points, > 0
  /// The turning angle at a point [rad], in (0, π); and that times the longer of the spacings
  /// beside it, so that points gather where the manifold bends.
  double most_turning = 0.3;
  double most_turning_by_spacing = 1e-3;
  /// Spacings are not made shorter than this for the sake of the turning angle: tips of folds are
  /// sharper than any resolution.
  double least_spacing = 1e-5;
  std::int64_t most_points = 200'000;  ///< of each side
  int most_generations = 2000;
  /// The manifold starts along its tangent, where that deviates from it by less than this fraction
  /// of the distance from the saddle.
  double linear_error = 1e-6;
  /// What one call of AdvanceManifold does: so many iterates of the map, or so many visits.
  std::int64_t most_iterates = 50'000;
  std::int64_t most_visits = 4000;
  /// Units of the coordinates for all lengths and angles above; empty: all 1.
  Point scale;
};

enum class ManifoldEnd {
  kNotYet,
  kLength,  ///< as long as asked for
  kMostPoints,
  kMostGenerations,  ///< it winds up at an attracting cycle, say, and grows no longer
  kLost,             ///< it leaves the domain: `message`
  kTorn,             ///< neighbours part however close they start: the map is not continuous there
};

/// A point of the manifold.
struct ManifoldPoint {
  Point point;
  double arc_length = 0;  ///< from the saddle, in the units of `scale`
  int generation = 0;     ///< it is G^generation of a point of the first fundamental segment
};

/// One side of a manifold under way: plain data, all that is needed to go on with it.
///
/// The side is the union of the images of a fundamental segment, whose points are
/// point + side · step · expansion^s · tangent, s in [0, 1].
struct ManifoldSide {
  int side = 1;
  double step = 0;
  int generation = 0;
  std::vector<double> s;                   ///< increasing, from 0 to 1
  std::vector<Point> points;               ///< G^generation of the segment's points at `s`
  std::vector<Point> images;               ///< G of the first of `points`, so far
  bool refining = false;                   ///< `points` are not yet as close as asked for
  std::int64_t visited = 0;                ///< of `points`
  double arc_length = 0;                   ///< up to the next of `points` to be visited
  std::int64_t written = 0;                ///< points visited so far, of all generations
  ManifoldEnd end = ManifoldEnd::kNotYet;  ///< why nothing follows these points
  std::string message;
  bool done = false;  ///< all points have been visited
};

/// The fundamental segment on one side (`side` = ±1) of a saddle. INVALID_ARGUMENT names an option
/// out of range; OUT_OF_RANGE: G is not linear to `linear_error` however near the saddle.
absl::StatusOr<ManifoldSide> StartManifold(const Map& map, const Saddle& saddle, int side,
                                           const ManifoldOptions& options);

/// Called with each point, in order along the manifold from the saddle on; false stops (CANCELLED;
/// `side` is then as it was before the call, whose points come again).
using ManifoldVisit = absl::FunctionRef<bool(const ManifoldPoint& point)>;

/// Goes on by a part of what is to be done, about as much as the options say, until side.done;
/// side.end then says why. By turns, the points of a generation are visited, mapped to the next,
/// and that is refined.
///
/// Method: Hobson (J. Comput. Phys. 104 (1993) 14), with the criteria of Krauskopf & Osinga (J.
/// Comput. Phys. 146 (1998) 404). Each generation is the image of the one before, with points put
/// in between where neighbours are too far apart or the polygon turns too much. A new point is the
/// image of its own start on the fundamental segment, nothing is interpolated, so that each is as
/// close to the manifold as the map is accurate: errors across it die out. Points of one round go
/// to the map together, which may compute them side by side.
absl::Status AdvanceManifold(const Map& map, const Saddle& saddle, const ManifoldOptions& options,
                             ManifoldSide& side, ManifoldVisit visit);

}  // namespace celt
