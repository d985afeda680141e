#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "core/analysis/hyperbolicity_sums.h"

namespace celt {

enum class HyperbolicityVerdict {
  kPseudoHyperbolic,  ///< every test was passed
  kTangencies,        ///< a chaotic attractor on which E^ss meets E^cu or is not continuous
  kUndecided,         ///< anything else, a regular attractor among it
};

enum class TestOutcome { kPassed, kFailed, kOpen };

/// One test, with the number that it is about.
struct HyperbolicityTest {
  const char* name;  ///< "exponents", "settled", "angle", "lmp", "growth"
  TestOutcome outcome = TestOutcome::kOpen;
  double value = 0;
  double pass_limit = 0;
  double fail_limit = 0;
  /// How far inside: positive when passed, negative when failed or open; in the units of `value`,
  /// for "angle" in decades.
  double margin = 0;
  std::string why;  ///< one line
};

/// The lower tail of the angle's distribution, P(θ < t) ∝ t^κ, by Hill's estimator over the least
/// block minima (Hill, Ann. Statist. 3 (1975) 1163).
struct AngleTail {
  double index = 0;  ///< κ; infinity when all of the tail is equal
  double standard_error = 0;
  int blocks = 0;  ///< used; 0 when there were too few
  /// min θ · 100^(−1/κ): the minimum that the tail promises for an orbit a hundred times as long.
  double promised_minimum = 0;
};

struct HyperbolicityReport {
  LyapunovReport spectrum;
  std::int64_t samples = 0;
  ClosestApproach minimum;
  std::vector<std::pair<double, double>> quantiles;  ///< (fraction, angle [rad])
  std::array<double, 4> minimum_by_length;   ///< over the first 1/8, 1/4, 1/2 and all of the orbit
  std::array<double, 8> minimum_by_segment;  ///< over each eighth of the orbit
  AngleTail tail;
  std::array<double, kGrowthWindows.size()> least_growth;  ///< per iterate, by kGrowthWindows
  std::vector<LmpBin> lmp_graph;
  double disagreement = 0;
  std::vector<HyperbolicityTest> tests;
  HyperbolicityVerdict verdict = HyperbolicityVerdict::kUndecided;
};

/// Tests an orbit's splitting; all angles are in whitened coordinates.
///
/// - "exponents": the paper's inequalities (Λ1 > 0, Λ1 + Λ2 > 0, ΣΛ < 0, Λ3 < Λ2), the least of
///   their margins in standard errors: passed above 2, failed below −2. Maps of dimension 3 only.
/// - "settled": E^ss is known to 10⁻⁶ rad at every sample; failed or passed.
/// - "angle": θ is bounded away from 0. On an attractor with tangencies θ passes through 0
///   transversally, P(θ < t) falls like a power of t of about one, and the minimum falls like 1/N;
///   on a pseudo-hyperbolic one the tail ends, and κ is large. A minimum alone says neither. The
///   test looks at the minimum that the tail promises for an orbit a hundred times as long: passed
///   when above a tenth of the median of θ, failed when below a hundredth of it.
///   Three-dimensional Hénon map: κ = 150 for M2 = 0.815, 1.2 ± 0.2 for M2 = 0.85.
/// - "lmp": φ → 0 as ρ → 0. The largest φ over pairs closer than kLmpNear standard deviations
///   (at least 100): passed below 0.2 rad, failed above 0.5 rad. On the Hénon map E^ss turns by at
///   most some 3 rad per standard deviation for M2 = 0.815; for M2 = 0.85 near pairs cross at π/2.
/// - "growth": there is a window over which (n−1)-volume on E^cu grows wherever it begins: passed
///   when the least growth is positive for some window; it never fails, for a longer window might
///   pass.
///
/// PSEUDO_HYPERBOLIC when all are passed. TANGENCIES when "exponents" does not fail, "settled" is
/// passed, and "angle" or "lmp" fails. Else UNDECIDED. All of it is numerical evidence along one
/// orbit, no proof.
///
/// INVALID_ARGUMENT: fewer than 16 blocks of samples (the message says how many iterates it
/// takes).
absl::StatusOr<HyperbolicityReport> JudgeHyperbolicity(const HyperbolicitySums& sums,
                                                       const HyperbolicityOptions& options,
                                                       const LmpOptions& lmp = {});

/// The least iterates of which JudgeHyperbolicity gives a verdict.
std::int64_t LeastIterates(const HyperbolicityOptions& options);

inline constexpr double kLmpNear = 0.0316227766;  ///< [standard deviations], an edge of a bin

/// A whole orbit in one call.
struct HyperbolicityRun {
  std::int64_t transient = 2000;  ///< for the point and the frame
  std::int64_t scout = 5000;      ///< iterates that the whitening is made from, after the transient
  std::int64_t iterates = 20000;
  std::int64_t stretch = 2000;  ///< to which the memory is proportional
  HyperbolicityOptions options;
};

/// Transient, whitening, stretches and verdict of one orbit. `start` as DrawStarts gives it. Status
/// as of AdvanceSplitting and JudgeHyperbolicity. `tick` counts from the start of each stretch.
absl::StatusOr<HyperbolicityReport> MeasureHyperbolicity(const Map& map, FramedOrbit start,
                                                         const HyperbolicityRun& run,
                                                         LyapunovTick tick);

}  // namespace celt
