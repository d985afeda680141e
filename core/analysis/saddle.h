#pragma once

#include <span>

#include "absl/status/statusor.h"
#include "core/analysis/shooting.h"
#include "core/map/map.h"

namespace celt {

/// A point of a cycle with a one-dimensional manifold along which orbits leave it: its unstable
/// manifold, or the stable one when time runs backward.
struct Saddle {
  Point point;
  Direction direction = Direction::kForward;
  /// Iterates of the map, in `direction`, that keep each side of the manifold: the period, or twice
  /// the period when the multiplier is negative. Write G for them together.
  int iterates = 1;
  double expansion = 0;  ///< the multiplier of G along the manifold, > 1
  Point tangent;         ///< unit vector along the manifold; side +1 is where it points
  /// Covector that vanishes on the other directions, ⟨normal, tangent⟩ = 1: the sign of
  /// ⟨normal, x − point⟩ is the side of the other manifold, near the point.
  Point normal;
};

/// The saddle at the first of the points of a cycle, as FindCycle gives them.
///
/// INVALID_ARGUMENT: the points are no cycle of the map (the message has the residual), or not
/// exactly one multiplier lies outside the unit circle (inside, when going backward), on which
/// side they do lie being told by the message, which has them all. Else status as of Map::Apply.
absl::StatusOr<Saddle> MakeSaddle(const Map& map, std::span<const Point> cycle,
                                  Direction direction);

/// x → G(x) for many points at once. Statuses are in the order of the points; images of points
/// that failed mean nothing.
struct Images {
  std::vector<Point> points;
  std::vector<absl::Status> statuses;
};
Images ApplyMany(const Map& map, std::span<const Point> points, std::int64_t iterates,
                 Direction direction);

}  // namespace celt
