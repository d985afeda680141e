#pragma once

#include <complex>
#include <span>
#include <vector>

#include "Eigen/Core"
#include "absl/status/statusor.h"
#include "core/map/map.h"

namespace celt {

/// An eigenvalue of the derivative of F^k on a cycle of period k.
using Multiplier = std::complex<double>;

/// Points x_0, …, x_{k−1} as the unknown of the equation of multiple shooting,
///
///     R_i = F(x_i) − x_{i+1 mod k} = 0,   i = 0, …, k − 1,
///
/// with the map's own difference. Stacks, that is points one under the other, are vectors of k n
/// numbers (n the map's dimension). All functions here are pure.
struct Shot {
  std::vector<Image> images;  ///< F(x_i)
  Eigen::VectorXd residual;   ///< R, a stack
};

/// Applies the map to every point. Status: of the first point, in order, that failed, as of
/// Map::Apply.
absl::StatusOr<Shot> Shoot(const Map& map, std::span<const Point> points, Derivative derivative);

/// ∂R/∂(x_0, …, x_{k−1}), k n × k n: DF(x_i) on the diagonal, −1 to its right, cyclically. The shot
/// must have Jacobians.
Eigen::MatrixXd ShootingJacobian(const Shot& shot);

/// DF^k(x_0) = DF(x_{k−1}) … DF(x_0). The shot must have Jacobians.
SquareMatrix CycleJacobian(const Shot& shot);

/// Sum of the times of the shot's images.
double TotalTime(const Shot& shot);

/// The eigenvalues, by decreasing modulus; of a complex pair the one with positive imaginary part
/// first. With a modulus below some 1e-14 of the largest, rounding is all that is left of one.
std::vector<Multiplier> MultipliersOf(const SquareMatrix& jacobian);

/// a − b as a stack of tangent vectors, by the map's difference.
Eigen::VectorXd StackDifference(const Map& map, std::span<const Point> a, std::span<const Point> b);

/// points + factor · stack.
std::vector<Point> Displaced(std::span<const Point> points, double factor,
                             const Eigen::VectorXd& stack);

/// Each point as the map itself would write it, angles in the map's own range: the image of the
/// point before, less what R says that it is off.
std::vector<Point> InMapsRange(const Map& map, std::span<const Point> points, const Shot& shot);

}  // namespace celt
