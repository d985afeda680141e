#include "core/analysis/corrector.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "Eigen/LU"
#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace celt {
namespace {

constexpr double kSingular = 1e-15;
constexpr int kMostCorrections = 12;
/// Corrections that stop shrinking within this factor of the tolerance have met the map's own
/// error.
constexpr double kStagnation = 1e3;

Corrected Failed(CycleTermination termination, const ExtendedPoint& at, std::string message) {
  Corrected failed;
  failed.parameter = at.parameter;
  failed.cycle.termination = termination;
  failed.cycle.message = std::move(message);
  failed.cycle.points = at.points;
  return failed;
}

Corrected Lost(const ExtendedPoint& at, const absl::Status& status) {
  return Failed(CycleTermination::kLeftDomain, at, std::string(status.message()));
}

}  // namespace

BranchEquation::BranchEquation(const MapFamily& family, double scale, double difference_step,
                               const NewtonOptions& newton)
    : family_(family), scale_(scale), difference_step_(difference_step), newton_(newton) {
  assert(scale > 0 && difference_step > 0);
}

/// F_{p+step}(x) − F_{p−step}(x), a stack.
absl::StatusOr<Eigen::VectorXd> BranchEquation::ImagesOver(const ExtendedPoint& u,
                                                           double step) const {
  std::vector<Point> images[2];
  std::unique_ptr<Map> map;
  for (const int side : {0, 1}) {
    auto made = family_(u.parameter + (side == 0 ? -step : step));
    if (!made.ok()) return made.status();
    map = *std::move(made);
    auto shot = Shoot(*map, u.points, Derivative::kNone);
    if (!shot.ok()) return shot.status();
    for (const Image& image : shot->images) images[side].push_back(image.point);
  }
  return StackDifference(*map, images[1], images[0]);
}

absl::StatusOr<ParameterDerivative> BranchEquation::DifferentiateByParameter(
    const ExtendedPoint& u) const {
  const double h = difference_step_;
  const auto near = ImagesOver(u, h);
  if (!near.ok()) return near.status();
  const auto far = ImagesOver(u, 2 * h);
  if (!far.ok()) return far.status();
  const Eigen::VectorXd second_order = *near / (2 * h);
  ParameterDerivative derivative;
  derivative.value = (4 * second_order - *far / (4 * h)) / 3;
  derivative.step = h;
  derivative.error = (derivative.value - second_order).norm();
  return derivative;
}

/// (∂R/∂y; rowᵀ). OUT_OF_RANGE when an entry is not finite.
absl::StatusOr<Eigen::MatrixXd> BranchEquation::Border(const Shot& shot,
                                                       const Eigen::VectorXd& derivative,
                                                       const Eigen::VectorXd& row) const {
  const Eigen::Index size = derivative.size();
  Eigen::MatrixXd matrix(size + 1, size + 1);
  const double root = std::sqrt(static_cast<double>(shot.images.size()));
  matrix.topLeftCorner(size, size) = root * ShootingJacobian(shot);
  matrix.topRightCorner(size, 1) = scale_ * derivative;
  matrix.bottomRows(1) = row.transpose();
  if (!matrix.allFinite()) return absl::OutOfRangeError("a derivative of the map is not finite");
  return matrix;
}

absl::StatusOr<BranchEquation::Direction> BranchEquation::DirectionAt(
    const ExtendedPoint& u, const Eigen::VectorXd& towards) const {
  const auto map = family_(u.parameter);
  if (!map.ok()) return map.status();
  const auto shot = Shoot(**map, u.points, Derivative::kJacobian);
  if (!shot.ok()) return shot.status();
  const auto derivative = DifferentiateByParameter(u);
  if (!derivative.ok()) return derivative.status();
  const auto matrix = Border(*shot, derivative->value, towards);
  if (!matrix.ok()) return matrix.status();
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(*matrix);
  if (!(lu.rcond() > kSingular)) {
    return absl::FailedPreconditionError(absl::StrCat(
        "the direction of the branch is undefined at ", u.parameter, ": branches meet there"));
  }
  const Eigen::VectorXd solution =
      lu.solve(Eigen::VectorXd::Unit(towards.size(), towards.size() - 1));
  return Direction{.tangent = solution.normalized(), .orientation = lu.determinant() < 0 ? -1 : 1};
}

Corrected BranchEquation::Correct(const ExtendedPoint& predicted,
                                  const Eigen::VectorXd& normal) const {
  const auto derivative = DifferentiateByParameter(predicted);
  if (!derivative.ok()) return Lost(predicted, derivative.status());
  ExtendedPoint u = predicted;
  double before = std::numeric_limits<double>::infinity();
  for (int i = 1; i <= kMostCorrections; ++i) {
    const auto map = family_(u.parameter);
    if (!map.ok()) return Lost(u, map.status());
    const auto shot = Shoot(**map, u.points, Derivative::kJacobian);
    if (!shot.ok()) return Lost(u, shot.status());
    const auto matrix = Border(*shot, derivative->value, normal);
    if (!matrix.ok()) return Lost(u, matrix.status());
    Eigen::VectorXd right = Eigen::VectorXd::Zero(normal.size());
    right.head(shot->residual.size()) = -shot->residual;
    const Eigen::VectorXd step = matrix->partialPivLu().solve(right);
    const double length = step.norm();
    if (!std::isfinite(length)) {
      return Failed(CycleTermination::kSingular, u, "the bordered Jacobian is singular");
    }
    const bool stagnates = !(length <= before / 2);
    if (stagnates && !(length <= kStagnation * newton_.tolerance)) break;
    u = Move(u, 1, step);
    if (stagnates || length <= newton_.tolerance) return Describe(u, i, length);
    before = length;
  }
  return Failed(CycleTermination::kNoConvergence, u, "corrections do not shrink");
}

Corrected BranchEquation::Describe(const ExtendedPoint& u, int iterations,
                                   double correction) const {
  const auto map = family_(u.parameter);
  if (!map.ok()) return Lost(u, map.status());
  auto cycle = DescribeCycle(**map, u.points);
  if (!cycle.ok()) return Lost(u, cycle.status());
  cycle->iterations = iterations;
  cycle->correction = correction;
  return {.cycle = *std::move(cycle), .parameter = u.parameter};
}

Corrected BranchEquation::CorrectAt(double parameter, const std::vector<Point>& guess) const {
  const auto map = family_(parameter);
  if (!map.ok()) return Lost({.points = guess, .parameter = parameter}, map.status());
  auto cycle = FindCycle(**map, guess, newton_);
  if (!cycle.ok()) return Lost({.points = guess, .parameter = parameter}, cycle.status());
  return {.cycle = *std::move(cycle), .parameter = parameter};
}

ExtendedPoint BranchEquation::Move(const ExtendedPoint& u, double length,
                                   const Eigen::VectorXd& along) const {
  const double root = std::sqrt(static_cast<double>(u.points.size()));
  return {.points = Displaced(u.points, length * root, along),
          .parameter = u.parameter + length * scale_ * along[along.size() - 1]};
}

absl::StatusOr<Eigen::VectorXd> BranchEquation::Difference(const ExtendedPoint& a,
                                                           const ExtendedPoint& b) const {
  const auto map = family_(a.parameter);
  if (!map.ok()) return map.status();
  const Eigen::VectorXd stack = StackDifference(**map, a.points, b.points);
  Eigen::VectorXd difference(stack.size() + 1);
  difference << stack / std::sqrt(static_cast<double>(a.points.size())),
      (a.parameter - b.parameter) / scale_;
  return difference;
}

}  // namespace celt
