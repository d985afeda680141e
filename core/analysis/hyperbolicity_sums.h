#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/analysis/lmp_graph.h"
#include "core/analysis/lyapunov.h"
#include "core/analysis/splitting.h"
#include "core/analysis/whitening.h"

namespace celt {

/// The lengths of the windows over which finite-time growth is measured [iterates].
inline constexpr std::array<std::int64_t, 10> kGrowthWindows = {1,  2,   5,   10,  20,
                                                                50, 100, 200, 500, 1000};

/// How an orbit's splitting is summed up.
struct HyperbolicityOptions {
  /// Iterates over which E^ss settles, dropped at the orbit's end: the error left is about
  /// exp(−settle (Λ(n−1) − Λn)).
  std::int64_t settle = 300;
  /// Samples to a block. Tangency is invariant, so small angles come in runs; of each block only
  /// the least is taken for independent of others.
  std::int64_t block = 100;
  /// Every so many samples one goes to the LMP graph, and they are kept: 150 bytes each.
  std::int64_t lmp_stride = 1;
};

/// Where E^ss and E^cu came closest.
struct ClosestApproach {
  double angle = std::numeric_limits<double>::infinity();  ///< [rad]
  std::int64_t iterate = 0;
  Point point;
};

/// Angles, counted in bins of equal ratio.
class AngleHistogram {
 public:
  void Add(double angle);
  std::int64_t count() const;
  /// The angle below which a fraction of the angles lies, good to half a bin, 2 %. Precondition:
  /// count() > 0.
  double Quantile(double fraction) const;

  /// Plain data, to be stored.
  std::vector<std::int64_t> bins;
};

/// What is kept of an orbit's splitting: plain data whose size grows by 8 bytes a block and 150
/// bytes an LMP point, and not with the orbit otherwise.
struct HyperbolicitySums {
  std::vector<LyapunovSums> batches;  ///< one a stretch
  std::int64_t samples = 0;
  AngleHistogram angles;
  ClosestApproach closest;
  std::vector<double> block_minima;  ///< the least angle of each block, in the orbit's order; the
                                     ///< last block may be under way
  double disagreement = 0;           ///< see SplittingStretch
  /// ln of whitened (n−1)-volume on E^cu along the orbit, the last values, the newest last.
  std::vector<double> recent_volume;
  double log_volume = 0;
  /// The least of (ln volume growth)/w over all windows of w = kGrowthWindows iterates.
  std::array<double, kGrowthWindows.size()> least_growth;
  std::vector<LmpPoint> lmp_points;

  HyperbolicitySums() { least_growth.fill(std::numeric_limits<double>::infinity()); }
};

/// Folds the next stretch of the orbit in. Whitened volume on E^cu is that of the coordinates times
/// |det W| |W⁻ᵀn| with n the unit normal, so that growth telescopes over a window.
void AddStretch(const Map& map, const Whitening& whitening, const HyperbolicityOptions& options,
                const SplittingStretch& stretch, HyperbolicitySums& sums);

}  // namespace celt
