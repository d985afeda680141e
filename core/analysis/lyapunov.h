#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "absl/functional/function_ref.h"
#include "absl/status/statusor.h"
#include "core/map/map.h"

namespace celt {

/// An orbit with an orthonormal frame of tangent vectors: all that is needed to go on with it.
struct FramedOrbit {
  Point point;
  SquareMatrix frame;  ///< columns orthonormal; the first k span the k most expanding directions
};

/// Sums over a stretch of an orbit. Sums of stretches add.
struct LyapunovSums {
  std::int64_t iterates = 0;
  double time = 0;    ///< sum of return times
  Point log_stretch;  ///< Σ ln R_ii of the successive QR factorisations, one entry a direction
  LyapunovSums& operator+=(const LyapunovSums& other);
};

/// Called after each iterate with the number of iterates done since the call began; false stops
/// early (CANCELLED).
using LyapunovTick = absl::FunctionRef<bool(std::int64_t iterates)>;

/// Advances the orbits by `iterates` each, with DF·Q = Q'R after each iterate (Benettin et al.
/// 1980; Shimada & Nagashima 1979), R_ii > 0. Adds to nothing: `sums[i]` is the stretch just done.
/// Status: the first orbit, in order, that failed, as of Map::Apply;
/// OUT_OF_RANGE when a Jacobian is singular.
absl::StatusOr<std::vector<LyapunovSums>> AdvanceFrames(const Map& map,
                                                        std::span<FramedOrbit> orbits,
                                                        std::int64_t iterates, LyapunovTick tick);

/// From fewer batches than this no standard error is told: their scatter would say too little.
inline constexpr int kFewestBatches = 4;

/// An estimate with its standard error.
struct Estimate {
  double value = 0;
  double standard_error = 0;  ///< 0 from fewer than kFewestBatches
};

/// An inequality of the paper's §3.2 on the exponents: lhs > 0.
struct LyapunovCondition {
  const char* name;  ///< "lambda1 > 0", "lambda1 + lambda2 > 0", "lambda1 + lambda2 + lambda3 < 0",
                     ///< "lambda3 < lambda2"
  bool holds = false;  ///< of the estimate itself
  Estimate slack;      ///< how far inside, per iterate: positive where it holds
  double margin = 0;   ///< slack in its standard errors
};

/// The Lyapunov spectrum, ordered as the frame is (which is from the largest, up to statistics).
struct LyapunovReport {
  std::int64_t iterates = 0;
  std::int64_t batches = 0;  ///< that the standard errors are from
  Estimate return_time;
  std::vector<Estimate> per_iterate;
  std::vector<Estimate> per_time;
  Estimate sum_per_iterate;
  Estimate sum_per_time;
  double kaplan_yorke_dimension = 0;
  std::vector<LyapunovCondition> conditions;  ///< of three-dimensional maps only
};

/// The spectrum from batches of equal weight per iterate, with standard errors by batch means: the
/// scatter of the batches about their common mean. One batch an orbit is best where there are
/// orbits enough: what an exponent's sum has at the ends of a batch is taken for scatter, and half
/// of it cancels between batches that follow each other. Precondition: at least one batch, none
/// without iterates.
LyapunovReport Summarize(std::span<const LyapunovSums> batches);

/// Kaplan & Yorke's dimension j + (Λ1 + … + Λj)/|Λ(j+1)| of exponents in decreasing order; the
/// number of exponents when their sum is not negative, 0 when the first is negative.
double KaplanYorkeDimension(std::span<const double> exponents);

/// `count` starts in the box `start` ± `spread`, each with a random frame; a single one starts at
/// `start` itself. The same for the same seed on every machine, and the first ones the same
/// whatever the count (from 2 on).
std::vector<FramedOrbit> DrawStarts(const Point& start, const Point& spread, int count,
                                    std::uint64_t seed);

}  // namespace celt
