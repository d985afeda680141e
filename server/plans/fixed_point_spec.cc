#include "server/plans/fixed_point_spec.h"

#include <cmath>
#include <numbers>
#include <string>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/convert.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

constexpr std::int64_t kMostStarts = 10'000'000;
constexpr int kMostIterations = 10'000;
/// Of the box around a start from which the starts of independent orbits are drawn.
constexpr double kBoxSize = 100;

bool IsStone(const v1::JobSpec& spec) {
  return spec.system().name() == AllSystems().front()->name();
}

/// Coordinates as they are given, whatever the frame.
PointFrame AsGiven(v1::JobSpec spec) {
  spec.set_frame(v1::FRAME_BODY);
  return PointFrame(spec);
}

/// The stone's domain is the same in both frames.
Point DefaultCorner(const System& system, const v1::JobSpec& spec, int side) {
  if (IsStone(spec)) return Eigen::Vector3d(side < 0 ? 0 : 2 * std::numbers::pi, side, side);
  return system.DefaultStart() + side * kBoxSize * system.StartSpread();
}

absl::StatusOr<Point> ResolveCorner(const System& system, const v1::JobSpec& spec, bool given,
                                    int side, v1::Point& corner) {
  const PointFrame frame = AsGiven(spec);
  if (!given) corner = frame.FromPoint(DefaultCorner(system, spec, side));
  CELT_ASSIGN_OR_RETURN(Point point, frame.ToPoint(corner));
  CELT_RETURN_IF_ERROR(CheckPoint(system, point));
  for (Eigen::Index i = 1; IsStone(spec) && i < point.size(); ++i) {
    if (std::abs(point[i]) <= 1) continue;
    return absl::InvalidArgumentError(absl::StrCat(std::string(system.coordinates()[i]), ": ",
                                                   point[i],
                                                   " is not allowed; it lies in [-1, 1]"));
  }
  return point;
}

absl::Status CheckOrder(const System& system, const Point& lower, const Point& upper) {
  for (Eigen::Index i = 0; i < lower.size(); ++i) {
    if (lower[i] <= upper[i]) continue;
    return absl::InvalidArgumentError(
        absl::StrCat("upper: ", std::string(system.coordinates()[i]), ": ", upper[i],
                     " is not allowed; it is no less than the ", lower[i], " of lower"));
  }
  return absl::OkStatus();
}

absl::Status ResolveBox(const System& system, v1::JobSpec& spec) {
  v1::FixedPointSpec& fixed_point = *spec.mutable_fixed_point();
  const auto named = [](const char* field, const absl::Status& status) {
    return absl::Status(status.code(), absl::StrCat(field, ": ", status.message()));
  };
  const bool lower_given = fixed_point.has_lower();
  const bool upper_given = fixed_point.has_upper();
  const auto lower = ResolveCorner(system, spec, lower_given, -1, *fixed_point.mutable_lower());
  if (!lower.ok()) return named("lower", lower.status());
  const auto upper = ResolveCorner(system, spec, upper_given, 1, *fixed_point.mutable_upper());
  if (!upper.ok()) return named("upper", upper.status());
  return CheckOrder(system, *lower, *upper);
}

absl::Status ResolveSearch(const System& system, v1::JobSpec& spec) {
  v1::FixedPointSpec& fixed_point = *spec.mutable_fixed_point();
  if (fixed_point.has_near()) {
    return absl::InvalidArgumentError("near: not together with search, which draws its starts");
  }
  CELT_RETURN_IF_ERROR(CheckRange("search", fixed_point.search(), 1, kMostStarts));
  if (!fixed_point.has_seed()) fixed_point.set_seed(1);
  return ResolveBox(system, spec);
}

absl::Status ResolveGuess(const System& system, v1::JobSpec& spec) {
  v1::FixedPointSpec& fixed_point = *spec.mutable_fixed_point();
  const char* misplaced = fixed_point.has_seed()    ? "seed"
                          : fixed_point.has_lower() ? "lower"
                          : fixed_point.has_upper() ? "upper"
                                                    : nullptr;
  if (misplaced != nullptr) {
    return absl::InvalidArgumentError(absl::StrCat(misplaced, ": only for a search; set search"));
  }
  return ResolvePoint(system, spec, "near", *fixed_point.mutable_near());
}

}  // namespace

absl::Status ResolveFixedPoint(const System& system, v1::JobSpec& spec) {
  v1::FixedPointSpec& fixed_point = *spec.mutable_fixed_point();
  const NewtonOptions newton;
  if (!fixed_point.has_period()) fixed_point.set_period(1);
  if (!fixed_point.has_newton_tolerance()) fixed_point.set_newton_tolerance(newton.tolerance);
  if (!fixed_point.has_newton_iterations()) {
    fixed_point.set_newton_iterations(newton.max_iterations);
  }
  CELT_RETURN_IF_ERROR(CheckRange("period", fixed_point.period(), 1, kLongestPeriod));
  CELT_RETURN_IF_ERROR(CheckAbove("newton_tolerance", fixed_point.newton_tolerance(), 0, 1));
  CELT_RETURN_IF_ERROR(
      CheckRange("newton_iterations", fixed_point.newton_iterations(), 1, kMostIterations));
  return fixed_point.has_search() ? ResolveSearch(system, spec) : ResolveGuess(system, spec);
}

NewtonOptions NewtonOf(const v1::FixedPointSpec& spec) {
  NewtonOptions options;
  options.tolerance = spec.newton_tolerance();
  options.max_iterations = spec.newton_iterations();
  return options;
}

absl::StatusOr<CycleSearchOptions> SearchOf(const v1::JobSpec& resolved) {
  const v1::FixedPointSpec& fixed_point = resolved.fixed_point();
  const PointFrame frame(resolved);
  CELT_ASSIGN_OR_RETURN(const Point lower, frame.ToPoint(fixed_point.lower()));
  CELT_ASSIGN_OR_RETURN(const Point upper, frame.ToPoint(fixed_point.upper()));
  CycleSearchOptions options;
  options.period = fixed_point.period();
  options.seed = fixed_point.seed();
  options.newton = NewtonOf(fixed_point);
  options.lower = lower.cwiseMin(upper);
  options.upper = lower.cwiseMax(upper);
  if (!IsStone(resolved)) return options;
  // An angle is turned round, and reduced: the box goes up from the end that is now the first.
  options.lower[0] = resolved.frame() == v1::FRAME_PAPER ? upper[0] : lower[0];
  options.upper[0] = options.lower[0] + fixed_point.upper().l() - fixed_point.lower().l();
  return options;
}

}  // namespace celt::plans
