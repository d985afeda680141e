#include "core/analysis/shooting.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "Eigen/Eigenvalues"

namespace celt {

absl::StatusOr<Shot> Shoot(const Map& map, std::span<const Point> points, Derivative derivative) {
  Shot shot;
  shot.images.resize(points.size());
  const auto keep = [&shot](int i, const Image& image) {
    shot.images[i] = image;
    return true;
  };
  for (const absl::Status& status : map.AdvanceAll(points, {.derivative = derivative}, keep)) {
    if (!status.ok()) return status;
  }
  const Eigen::Index n = map.dimension();
  shot.residual.resize(static_cast<Eigen::Index>(points.size()) * n);
  for (std::size_t i = 0; i < points.size(); ++i) {
    shot.residual.segment(static_cast<Eigen::Index>(i) * n, n) =
        map.Difference(shot.images[i].point, points[(i + 1) % points.size()]);
  }
  return shot;
}

Eigen::MatrixXd ShootingJacobian(const Shot& shot) {
  const auto k = static_cast<Eigen::Index>(shot.images.size());
  const Eigen::Index n = shot.images.front().point.size();
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(k * n, k * n);
  for (Eigen::Index i = 0; i < k; ++i) {
    jacobian.block(i * n, i * n, n, n) = shot.images[i].jacobian;
    // Added, not set: with k = 1 both blocks are the same.
    jacobian.block(i * n, (i + 1) % k * n, n, n).diagonal().array() -= 1;
  }
  return jacobian;
}

SquareMatrix CycleJacobian(const Shot& shot) {
  SquareMatrix product = shot.images.front().jacobian;
  for (std::size_t i = 1; i < shot.images.size(); ++i) {
    product = (shot.images[i].jacobian * product).eval();
  }
  return product;
}

double TotalTime(const Shot& shot) {
  double time = 0;
  for (const Image& image : shot.images) time += image.time;
  return time;
}

std::vector<Multiplier> MultipliersOf(const SquareMatrix& jacobian) {
  const Eigen::EigenSolver<SquareMatrix> solver(jacobian, /*computeEigenvectors=*/false);
  assert(solver.info() == Eigen::Success && "the QR iteration converges for finite matrices");
  const auto& values = solver.eigenvalues();
  std::vector<Multiplier> multipliers(values.begin(), values.end());
  std::sort(multipliers.begin(), multipliers.end(), [](const Multiplier& a, const Multiplier& b) {
    if (std::abs(a) != std::abs(b)) return std::abs(a) > std::abs(b);
    return a.real() != b.real() ? a.real() > b.real() : a.imag() > b.imag();
  });
  return multipliers;
}

Eigen::VectorXd StackDifference(const Map& map, std::span<const Point> a,
                                std::span<const Point> b) {
  const Eigen::Index n = map.dimension();
  Eigen::VectorXd stack(static_cast<Eigen::Index>(a.size()) * n);
  for (std::size_t i = 0; i < a.size(); ++i) {
    stack.segment(static_cast<Eigen::Index>(i) * n, n) = map.Difference(a[i], b[i]);
  }
  return stack;
}

std::vector<Point> Displaced(std::span<const Point> points, double factor,
                             const Eigen::VectorXd& stack) {
  std::vector<Point> displaced(points.begin(), points.end());
  Eigen::Index row = 0;
  for (Point& point : displaced) {
    point += factor * stack.segment(row, point.size());
    row += point.size();
  }
  return displaced;
}

std::vector<Point> InMapsRange(const Map& map, std::span<const Point> points, const Shot& shot) {
  std::vector<Point> wrapped(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t next = (i + 1) % points.size();
    const Point& image = shot.images[i].point;
    wrapped[next] = image - map.Difference(image, points[next]);
  }
  return wrapped;
}

}  // namespace celt
