#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "core/analysis/lyapunov.h"
#include "core/map/map.h"

namespace celt {

/// Sums over points of an attractor, of their differences from a reference among them. Sums add
/// when the reference is the same. Coordinates that are angles are measured from the reference the
/// short way round (Map::Difference): an attractor should not span half a turn.
struct CovarianceSums {
  Point reference;
  std::int64_t count = 0;
  Point sum;
  SquareMatrix products;  ///< Σ d dᵀ
};

/// The affine change of coordinates y = W(x − x̄), W = C^(−1/2), that gives a set of points mean 0
/// and covariance 1. Attractors of section maps may be needles, and angles are measured in a
/// metric: this one is the attractor's own.
///
/// Standard deviations along the principal axes that are less than 10⁻⁹ of the largest are taken
/// for that; if all are no more than rounding of the coordinates (a fixed point), W = 1.
struct Whitening {
  Point mean;
  SquareMatrix matrix;   ///< W, symmetric
  SquareMatrix inverse;  ///< C^(1/2)

  /// W(x − x̄); `map` says how points are subtracted.
  Point Apply(const Map& map, const Point& x) const { return matrix * map.Difference(x, mean); }
  /// Unit tangent vector along W v.
  Point Direction(const Point& v) const { return (matrix * v).normalized(); }
  /// W⁻ᵀ n: annihilates W v wherever n annihilates v.
  Point Normal(const Point& n) const { return inverse.transpose() * n; }
};

/// Adds a point.
void AddPoint(const Map& map, const Point& x, CovarianceSums& sums);

/// Advances an orbit with its frame and adds the points it comes to: a scout, ahead of whatever
/// needs the whitening. Status as of AdvanceFrames; what was done before a failure stays done.
absl::Status AdvanceCovariance(const Map& map, FramedOrbit& orbit, std::int64_t iterates,
                               LyapunovTick tick, CovarianceSums& sums);

/// Precondition: at least one point was added.
Whitening WhiteningOf(const CovarianceSums& sums);

}  // namespace celt
