#include "core/analysis/splitting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "Eigen/LU"
#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "core/analysis/frame.h"
#include "core/analysis/line_angle.h"

namespace celt {
namespace {

absl::Status CheckArguments(const Map& map, std::int64_t iterates, std::int64_t settle) {
  if (map.dimension() < 2) {
    return absl::InvalidArgumentError("the map has dimension 1: there is nothing to split");
  }
  if (iterates < 1 || settle < 1) {
    return absl::InvalidArgumentError(
        absl::StrCat("iterates: ", iterates, ", settle: ", settle, "; both must be at least 1"));
  }
  return absl::OkStatus();
}

/// Appends the steps of the stretch to orbit.pending.
absl::Status StepForward(const Map& map, SplittingOrbit& orbit, std::int64_t iterates,
                         LyapunovTick tick, LyapunovSums& sums) {
  const Eigen::Index n = map.dimension();
  sums.log_stretch = Point::Zero(n);
  bool cancelled = false;
  bool singular = false;
  const auto visit = [&](int, const Image& image) {
    SplittingStep step;
    step.sample.iterate = orbit.iterates++;
    step.sample.point = orbit.orbit.point;
    step.sample.cu_normal = orbit.orbit.frame.col(n - 1);
    step.jacobian = image.jacobian;
    Point log_stretch = Point::Zero(n);
    singular = !PushFrame(image.jacobian, orbit.orbit.frame, log_stretch);
    step.sample.log_volume = log_stretch.head(n - 1).sum();
    orbit.orbit.point = image.point;
    orbit.pending.push_back(std::move(step));
    sums += {.iterates = 1, .time = image.time, .log_stretch = log_stretch};
    cancelled = !tick(sums.iterates);
    return !singular && !cancelled;
  };
  const Point start = orbit.orbit.point;
  const Advance advance = {.iterates = iterates, .derivative = Derivative::kJacobian};
  if (absl::Status status = map.AdvanceAll({&start, 1}, advance, visit).front(); !status.ok()) {
    return status;
  }
  if (singular) return absl::OutOfRangeError("the Jacobian is singular on the orbit");
  if (cancelled) return absl::CancelledError("stopped before the orbit was done");
  return absl::OkStatus();
}

/// Pulls two vectors back from the end of `steps`, which are then filled in, and returns the
/// largest angle between the two over the first `settled` steps. Neither starts in E^cu: the first
/// is its normal, the second leans away from it.
double PullBack(const SquareMatrix& frame, std::int64_t settled,
                std::vector<SplittingStep>& steps) {
  Point e = frame.col(frame.cols() - 1);
  Point other = frame.rowwise().sum();
  double disagreement = 0;
  for (auto i = static_cast<std::int64_t>(steps.size()) - 1; i >= 0; --i) {
    SplittingStep& step = steps[i];
    const Eigen::PartialPivLU<SquareMatrix> lu(step.jacobian);
    e = lu.solve(e).normalized();
    other = lu.solve(other).normalized();
    step.sample.stable = e;
    if (i < settled) disagreement = std::max(disagreement, AngleOfLines(e, other));
  }
  return disagreement;
}

}  // namespace

absl::StatusOr<SplittingStretch> AdvanceSplitting(const Map& map, SplittingOrbit& orbit,
                                                  std::int64_t iterates, std::int64_t settle,
                                                  LyapunovTick tick) {
  if (absl::Status status = CheckArguments(map, iterates, settle); !status.ok()) return status;
  SplittingOrbit next = orbit;
  SplittingStretch stretch;
  if (absl::Status status = StepForward(map, next, iterates, tick, stretch.sums); !status.ok()) {
    return status;
  }
  const auto steps = static_cast<std::int64_t>(next.pending.size());
  const std::int64_t settled = std::max<std::int64_t>(0, steps - settle);
  stretch.disagreement = PullBack(next.orbit.frame, settled, next.pending);
  for (std::int64_t i = 0; i < settled; ++i) {
    if (!next.pending[i].sample.stable.allFinite()) {
      return absl::OutOfRangeError("the Jacobian is singular on the orbit");
    }
    stretch.samples.push_back(std::move(next.pending[i].sample));
  }
  next.pending.erase(next.pending.begin(), next.pending.begin() + settled);
  orbit = std::move(next);
  return stretch;
}

double SplittingAngle(const Whitening& whitening, const SplittingSample& sample) {
  const Point e = whitening.Direction(sample.stable);
  const double sine = std::abs(whitening.Normal(sample.cu_normal).normalized().dot(e));
  return std::asin(std::min(1.0, sine));
}

}  // namespace celt
