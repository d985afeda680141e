#include "core/analysis/saddle.h"

#include <cmath>
#include <string>
#include <vector>

#include "Eigen/Eigenvalues"
#include "Eigen/LU"
#include "absl/strings/str_cat.h"

namespace celt {
namespace {

constexpr double kMostResidual = 1e-6;

std::string ListOf(std::span<const Multiplier> multipliers) {
  std::string list;
  for (const Multiplier& m : multipliers) {
    absl::StrAppend(&list, list.empty() ? "" : ", ", m.real());
    if (m.imag() != 0)
      absl::StrAppend(&list, m.imag() > 0 ? " + " : " - ", std::abs(m.imag()), "i");
  }
  return list;
}

/// The index of the multiplier along a one-dimensional manifold. Multipliers fall in modulus.
absl::StatusOr<std::size_t> LeavingMultiplier(std::span<const Multiplier> multipliers,
                                              Direction direction) {
  const bool forward = direction == Direction::kForward;
  std::size_t leaving = 0;
  for (const Multiplier& m : multipliers) {
    if (forward ? std::abs(m) > 1 : std::abs(m) < 1) ++leaving;
  }
  if (leaving == 1) return forward ? 0 : multipliers.size() - 1;
  return absl::InvalidArgumentError(
      absl::StrCat("cycle: has ", leaving, " multipliers ", forward ? "outside" : "inside",
                   " the unit circle; its ", forward ? "unstable" : "stable",
                   " manifold is one-dimensional only with exactly one. Its multipliers: ",
                   ListOf(multipliers)));
}

/// A real eigenvector v of a real simple eigenvalue: the kernel of A − λ.
Point Kernel(const SquareMatrix& a, double eigenvalue) {
  const Eigen::MatrixXd shifted = a - eigenvalue * SquareMatrix::Identity(a.rows(), a.cols());
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(shifted);
  // Inverse iteration would need a perturbed shift; the last column of the kernel by full pivoting
  // does not.
  const Eigen::MatrixXd upper = lu.matrixLU().triangularView<Eigen::Upper>();
  const Eigen::Index n = a.rows();
  Eigen::VectorXd y = Eigen::VectorXd::Zero(n);
  y[n - 1] = 1;
  y.head(n - 1) = upper.topLeftCorner(n - 1, n - 1)
                      .triangularView<Eigen::Upper>()
                      .solve(Eigen::VectorXd(-upper.topRightCorner(n - 1, 1)));
  const Eigen::VectorXd kernel = lu.permutationQ() * y;
  return kernel.normalized();
}

/// Largest component positive: a sign that small changes do not change.
Point Oriented(const Point& v) {
  Eigen::Index largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  return v[largest] > 0 ? v : Point(-v);
}

}  // namespace

absl::StatusOr<Saddle> MakeSaddle(const Map& map, std::span<const Point> cycle,
                                  Direction direction) {
  if (cycle.empty()) return absl::InvalidArgumentError("cycle: has no points");
  const auto shot = Shoot(map, cycle, Derivative::kJacobian);
  if (!shot.ok()) return shot.status();
  if (const double residual = shot->residual.lpNorm<Eigen::Infinity>(); residual > kMostResidual) {
    return absl::InvalidArgumentError(absl::StrCat("cycle: the points miss their images by ",
                                                   residual, "; at most ", kMostResidual,
                                                   " is allowed"));
  }
  const SquareMatrix jacobian = CycleJacobian(*shot);
  const std::vector<Multiplier> multipliers = MultipliersOf(jacobian);
  const auto leaving = LeavingMultiplier(multipliers, direction);
  if (!leaving.ok()) return leaving.status();
  const double multiplier = multipliers[*leaving].real();

  Saddle saddle;
  saddle.point = cycle.front();
  saddle.direction = direction;
  const int turns = multiplier < 0 ? 2 : 1;
  saddle.iterates = turns * static_cast<int>(cycle.size());
  const double per_turn = std::abs(multiplier);
  saddle.expansion = std::pow(direction == Direction::kForward ? per_turn : 1 / per_turn, turns);
  saddle.tangent = Oriented(Kernel(jacobian, multiplier));
  saddle.normal = Kernel(jacobian.transpose(), multiplier);
  saddle.normal /= saddle.normal.dot(saddle.tangent);
  return saddle;
}

Images ApplyMany(const Map& map, std::span<const Point> points, std::int64_t iterates,
                 Direction direction) {
  Images images;
  images.points.assign(points.begin(), points.end());
  const Advance advance = {.iterates = iterates, .direction = direction};
  images.statuses = map.AdvanceAll(points, advance, [&images](int i, const Image& image) {
    images.points[i] = image.point;
    return true;
  });
  return images;
}

}  // namespace celt
