#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/map/map.h"

namespace celt {

/// A point of an orbit with its strongly stable direction, both in whitened coordinates.
struct LmpPoint {
  std::int64_t iterate = 0;
  Point x;
  Point e;  ///< unit vector; its sign means nothing
};

/// Two points of the orbit: how far apart, and the angle between their directions.
struct LmpPair {
  double distance = 0;  ///< ρ, in standard deviations
  double angle = 0;     ///< φ in [0, π/2] [rad]
  std::int64_t first = 0;
  std::int64_t second = 0;  ///< iterates of the two, the later one second
};

/// Pairs of one range of distances.
struct LmpBin {
  double from = 0;        ///< least distance
  double to = 0;          ///< distances are below
  bool complete = false;  ///< every pair of the points was looked at, not a sample
  std::int64_t pairs = 0;
  LmpPair widest;               ///< the pair with the largest angle; of no meaning without pairs
  std::vector<LmpPair> sample;  ///< a few pairs, as if drawn at random, by iterates
};

struct LmpOptions {
  int bins_per_decade = 4;
  double least_distance = 1e-6;  ///< the first bin begins at 0 and ends here
  double largest_distance = 100;
  int sample = 40;                            ///< pairs kept in each bin
  std::int64_t most_near_pairs = 20'000'000;  ///< about as many candidates are looked at
  std::int64_t far_pairs = 500'000;
};

/// The LMP graph (light method of pseudo-hyperbolicity; Gonchenko, Kazakov & Turaev, Nonlinearity
/// 34 (2021) 2018): φ = arccos |⟨e(x_i), e(x_j)⟩| against ρ = |x_i − x_j| over pairs of points of
/// one orbit. Where E^ss depends continuously on the point, φ → 0 as ρ → 0.
///
/// All pairs would be N²/2. Those closer than a distance h are all looked at, with a grid of cells
/// of size h in the first three coordinates; h is the largest power of two for which there are at
/// most `most_near_pairs` candidates. Farther ones, which only the picture needs, are drawn by a
/// fixed sequence. Points so dense that h = 2⁻¹² is too large are thinned out. Time and memory are
/// thus bounded. Deterministic, in order of increasing distance; bins without pairs are there too.
std::vector<LmpBin> LmpGraph(std::span<const LmpPoint> points, const LmpOptions& options = {});

/// The widest pair over the bins below `distance`, and the number of pairs there.
struct LmpNear {
  std::int64_t pairs = 0;
  LmpPair widest;
};
LmpNear NearestPairs(std::span<const LmpBin> bins, double distance);

}  // namespace celt
