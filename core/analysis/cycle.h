#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "core/analysis/shooting.h"
#include "core/map/map.h"

namespace celt {

/// The longest period asked of FindCycle: the stacked equation is solved densely.
inline constexpr int kLongestPeriod = 256;

/// When Newton's method is content and when it gives up. Lengths are in the map's coordinates.
struct NewtonOptions {
  /// Converged when the Euclidean length of a Newton correction of the whole stack is no longer
  /// than this; the correction is still applied, so that the error left is about its square, or
  /// what the map's own error makes of it. In (0, 1].
  double tolerance = 1e-10;
  int max_iterations = 50;      ///< in [1, 10000]
  double least_damping = 1e-4;  ///< shortest fraction of a correction that is tried, in (0, 1]
};

/// Why the search for a cycle ended.
enum class CycleTermination {
  kConverged,
  kNoConvergence,  ///< no damped correction was shorter than the one before, or too many of them
  kLeftDomain,     ///< even the shortest correction left the map's domain, or the guess's orbit did
  kSingular,       ///< DF^k − 1 is singular to rounding: the correction is undefined
};

/// "converged", "no convergence", "left the domain", "singular".
std::string_view Name(CycleTermination termination);

/// Read `termination` before trusting anything else: unless it is kConverged, `points` is where the
/// method stood when it ended and the fields from `minimal_period` on are empty.
struct CycleReport {
  CycleTermination termination = CycleTermination::kNoConvergence;
  std::string message;        ///< one line on what happened, empty when converged
  int iterations = 0;         ///< Newton corrections computed
  std::vector<Point> points;  ///< x_0, x_1 = F(x_0), …
  double residual = 0;        ///< largest |F(x_i) − x_{i+1}|
  double correction = 0;      ///< length of the last correction: a bound for the points' error

  /// The least divisor d of the period with x_d = x_0; smaller than the period when the points are
  /// a shorter cycle gone round several times.
  int minimal_period = 0;
  double return_time = 0;               ///< of the whole cycle
  std::vector<Multiplier> multipliers;  ///< eigenvalues of DF^k(x_0), by decreasing modulus

  bool converged() const { return termination == CycleTermination::kConverged; }
};

/// Finds a cycle of the map by Newton's method on the equation of multiple shooting
/// (core/analysis/shooting.h) with the map's exact Jacobians. A correction is shortened by halves
/// until the next one, with the same Jacobian, is shorter too (natural monotonicity test: Deuflhard
/// 2011, §3.3), so that the outcome does not depend on the coordinates' units.
///
/// `guess` has as many points as the period. INVALID_ARGUMENT: no or too many points, a point that
/// is none of the map's, an option out of its range. Pure; safe from many threads.
absl::StatusOr<CycleReport> FindCycle(const Map& map, std::span<const Point> guess,
                                      const NewtonOptions& options = {});

/// The same from a single point, with its orbit as the guess. INVALID_ARGUMENT also when `period`
/// is not in [1, kLongestPeriod].
absl::StatusOr<CycleReport> FindCycle(const Map& map, const Point& guess, int period,
                                      const NewtonOptions& options = {});

/// The report of points that are taken to be a cycle as they are: residual, period, time,
/// multipliers; `termination` is kConverged. Status as of Map::Apply.
absl::StatusOr<CycleReport> DescribeCycle(const Map& map, std::span<const Point> points);

/// INVALID_ARGUMENT names the option out of range.
absl::Status CheckNewton(const NewtonOptions& options);

}  // namespace celt
