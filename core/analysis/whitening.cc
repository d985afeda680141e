#include "core/analysis/whitening.h"

#include <cassert>

#include "Eigen/Eigenvalues"
#include "core/analysis/frame.h"

namespace celt {
namespace {

/// Of coordinates: points closer than that are one point.
constexpr double kRounding = 1e-14;
constexpr double kLeastDeviation = 1e-9;  // of the largest

}  // namespace

absl::Status AdvanceCovariance(const Map& map, FramedOrbit& orbit, std::int64_t iterates,
                               LyapunovTick tick, CovarianceSums& sums) {
  Point log_stretch = Point::Zero(map.dimension());
  std::int64_t done = 0;
  bool cancelled = false;
  bool singular = false;
  const auto visit = [&](int, const Image& image) {
    singular = !PushFrame(image.jacobian, orbit.frame, log_stretch);
    orbit.point = image.point;
    AddPoint(map, image.point, sums);
    cancelled = !tick(++done);
    return !cancelled && !singular;
  };
  const Point start = orbit.point;
  const Advance advance = {.iterates = iterates, .derivative = Derivative::kJacobian};
  if (absl::Status status = map.AdvanceAll({&start, 1}, advance, visit).front(); !status.ok()) {
    return status;
  }
  if (singular) return absl::OutOfRangeError("the Jacobian is singular on the orbit");
  return cancelled ? absl::CancelledError("stopped before the orbit was done") : absl::OkStatus();
}

void AddPoint(const Map& map, const Point& x, CovarianceSums& sums) {
  if (sums.count == 0) {
    sums.reference = x;
    sums.sum = Point::Zero(x.size());
    sums.products = SquareMatrix::Zero(x.size(), x.size());
  }
  const Point d = map.Difference(x, sums.reference);
  sums.sum += d;
  sums.products += d * d.transpose();
  ++sums.count;
}

Whitening WhiteningOf(const CovarianceSums& sums) {
  assert(sums.count > 0);
  const auto count = static_cast<double>(sums.count);
  const Point offset = sums.sum / count;
  const SquareMatrix covariance = sums.products / count - offset * offset.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(covariance);
  Eigen::VectorXd deviation = axes.eigenvalues().cwiseMax(0).cwiseSqrt();
  const double largest = deviation.maxCoeff();
  const double size = sums.reference.cwiseAbs().maxCoeff() + 1;
  if (largest > kRounding * size) {
    deviation = deviation.cwiseMax(kLeastDeviation * largest);
  } else {
    deviation.setOnes();
  }
  const Eigen::MatrixXd& v = axes.eigenvectors();
  return {.mean = sums.reference + offset,
          .matrix = v * deviation.cwiseInverse().asDiagonal() * v.transpose(),
          .inverse = v * deviation.asDiagonal() * v.transpose()};
}

}  // namespace celt
