#pragma once

#include <string>
#include <vector>

#include "Eigen/Core"
#include "absl/status/statusor.h"
#include "core/analysis/cycle.h"
#include "core/map/map_family.h"

namespace celt {

/// Points of a would-be cycle and a value of the parameter.
struct ExtendedPoint {
  std::vector<Point> points;
  double parameter = 0;
};

/// How the derivative with respect to the parameter came out.
struct ParameterDerivative {
  Eigen::VectorXd value;  ///< ∂R/∂parameter, a stack
  double step = 0;        ///< of the parameter: differences over ±step and ±2 step
  double error = 0;       ///< estimated, in the Euclidean norm of `value`
};

/// What a correction gave; `cycle` is that of FindCycle, whose termination says how it went.
struct Corrected {
  CycleReport cycle;
  double parameter = 0;
};

/// The equation R(x, p) = 0 of cycles in the extended space of points and parameter, in the scaled
/// coordinates
///
///     y = (x_0/√k, …, x_{k−1}/√k, p/scale),
///
/// in which lengths, angles and tangents are measured. Tangents are unit vectors of k n + 1
/// numbers. Keeps references to its arguments; all functions are pure.
class BranchEquation {
 public:
  /// `scale` and `difference_step` in units of the parameter, both positive.
  BranchEquation(const MapFamily& family, double scale, double difference_step,
                 const NewtonOptions& newton);

  /// ∂R/∂p by central differences of fourth order, (4 D(h) − D(2h))/3 with D(h) over ±h; its
  /// `error` is the distance from D(h), a bound while the map's own error stays below.
  absl::StatusOr<ParameterDerivative> DifferentiateByParameter(const ExtendedPoint& u) const;

  /// The direction of the branch at a solution: unit, in the half space of `towards`.
  /// FAILED_PRECONDITION where it is undefined: two branches meet, or `towards` is orthogonal to
  /// it. Else status as of the family and Map::Apply.
  struct Direction {
    Eigen::VectorXd tangent;
    /// Sign of det(∂R/∂y; tangentᵀ), which changes where the branch crosses another.
    int orientation = 0;
  };
  absl::StatusOr<Direction> DirectionAt(const ExtendedPoint& u,
                                        const Eigen::VectorXd& towards) const;

  /// Newton's method in the hyperplane through `predicted` orthogonal to `normal`, with the
  /// Jacobian in x exact at every iterate and ∂R/∂p kept from the prediction. No damping: a
  /// prediction from which corrections do not shrink by half each time is too far off.
  Corrected Correct(const ExtendedPoint& predicted, const Eigen::VectorXd& normal) const;

  /// The cycle at a given value of the parameter, from a guess.
  Corrected CorrectAt(double parameter, const std::vector<Point>& guess) const;

  /// u moved by `length` along a vector of the scaled space.
  ExtendedPoint Move(const ExtendedPoint& u, double length, const Eigen::VectorXd& along) const;
  /// a − b as a vector of the scaled space.
  absl::StatusOr<Eigen::VectorXd> Difference(const ExtendedPoint& a, const ExtendedPoint& b) const;

  double scale() const { return scale_; }

 private:
  absl::StatusOr<Eigen::VectorXd> ImagesOver(const ExtendedPoint& u, double step) const;
  absl::StatusOr<Eigen::MatrixXd> Border(const Shot& shot, const Eigen::VectorXd& derivative,
                                         const Eigen::VectorXd& row) const;
  Corrected Describe(const ExtendedPoint& u, int iterations, double correction) const;

  const MapFamily& family_;
  double scale_;
  double difference_step_;
  NewtonOptions newton_;
};

}  // namespace celt
