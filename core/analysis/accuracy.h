#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "core/analysis/lyapunov.h"
#include "core/map/map.h"

namespace celt {

/// How far a map is from a better computed one, over a sample of points.
struct MapAccuracy {
  int sample = 0;             ///< points that were compared
  double map_error = 0;       ///< largest change of a coordinate of an image
  double jacobian_error = 0;  ///< largest change of an entry of DF, relative to the largest entry
  double drift = 0;           ///< largest Image::drift of the map itself
};

/// Compares `map` with `better`, the same map at a tighter tolerance, at each point of `sample`,
/// one forward iterate with its Jacobian. What is found is the error of `map` as far as that of
/// `better` is small beside it. Points whose orbit is lost are left out. INVALID_ARGUMENT: as of
/// Map::Apply.
absl::StatusOr<MapAccuracy> CompareMaps(const Map& map, const Map& better,
                                        std::span<const Point> sample);

/// What the error of the map's derivative does to each exponent per iterate: the mean over the
/// sample of ln R_ii by `map` less that by `better`, from the same points and frames, without sign.
/// (What the map's error does to the attractor itself is not in it; that is of the order of
/// MapAccuracy::map_error.) Orbits that are lost are left out; zeros when none is left.
absl::StatusOr<std::vector<double>> ExponentErrors(const Map& map, const Map& better,
                                                   std::span<const FramedOrbit> sample);

}  // namespace celt
