#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "core/analysis/lyapunov.h"
#include "core/analysis/whitening.h"
#include "core/map/map.h"

namespace celt {

/// The splitting of tangent space at a point of an orbit of an n-dimensional map, n ≥ 2, into the
/// strongly stable direction E^ss and the centre-unstable hyperplane E^cu.
struct SplittingSample {
  std::int64_t iterate = 0;  ///< since the orbit's frame began
  Point point;
  Point stable;           ///< unit vector along E^ss: a line, the sign means nothing
  Point cu_normal;        ///< unit normal of E^cu
  double log_volume = 0;  ///< ln of the growth of (n−1)-volume on E^cu in the iterate that follows
};

/// An iterate whose E^ss is not known yet: that takes the iterates after it.
struct SplittingStep {
  SplittingSample sample;  ///< without `stable`
  SquareMatrix jacobian;   ///< DF at the point
};

/// All that is needed to go on with an orbit: plain data, about 0.7 KB a pending step.
struct SplittingOrbit {
  FramedOrbit orbit;
  std::int64_t iterates = 0;
  std::vector<SplittingStep> pending;
};

/// What a stretch of the orbit gave.
struct SplittingStretch {
  LyapunovSums sums;                     ///< of all iterates of the stretch
  std::vector<SplittingSample> samples;  ///< in the orbit's order, where E^ss is known
  /// The largest angle [rad] between two different vectors pulled back, at any sample: how far
  /// E^ss has converged.
  double disagreement = 0;
};

/// Advances by `iterates`, and finds the splitting at the points that now have `settle` iterates
/// after them. The first stretch gives `iterates` − `settle` samples, each later one
/// `iterates`.
///
/// Forward, frames with QR (as AdvanceFrames): the first n − 1 columns span E^cu, and that is also
/// the span of the first n − 1 covariant Lyapunov vectors (Ginelli et al. 2007); the last is its
/// normal. Backward, a vector outside E^cu pulled back with DF⁻¹ turns to E^ss at the rate
/// Λ(n−1) − Λn per iterate (Kuptsov & Kuznetsov, Regul. Chaotic Dyn. 23 (2018) 908). Both
/// transients are dropped: the caller advances the frame before the first stretch, and `settle`
/// iterates at the end wait in `pending` for the next.
///
/// Memory: 0.7 KB an iterate of the stretch and of `settle`, whatever the orbit's length. Results
/// depend on how an orbit is cut into stretches only by what is left of the backward transient, see
/// `disagreement`.
///
/// INVALID_ARGUMENT: `iterates` < 1 or `settle` < 1, the map has dimension 1. OUT_OF_RANGE: the
/// orbit left the domain, or a Jacobian is singular. CANCELLED: `tick` said so; the orbit is then
/// as it was.
absl::StatusOr<SplittingStretch> AdvanceSplitting(const Map& map, SplittingOrbit& orbit,
                                                  std::int64_t iterates, std::int64_t settle,
                                                  LyapunovTick tick);

/// The angle in [0, π/2] between E^ss and E^cu in whitened coordinates [rad].
double SplittingAngle(const Whitening& whitening, const SplittingSample& sample);

}  // namespace celt
