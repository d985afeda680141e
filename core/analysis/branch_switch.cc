#include "core/analysis/branch_switch.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "Eigen/Eigenvalues"
#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace celt {
namespace {

/// A corrected cycle whose halves are less apart than this fraction of the prediction has fallen
/// back on the cycle of half the period.
constexpr double kFellBack = 0.5;

/// The real eigenvector of the eigenvalue nearest to −1.
Eigen::VectorXd FlipVector(const SquareMatrix& a) {
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(a);
  Eigen::Index best = 0;
  for (Eigen::Index i = 1; i < a.rows(); ++i) {
    const auto& mu = solver.eigenvalues();
    if (std::abs(mu[i] + 1.0) < std::abs(mu[best] + 1.0)) best = i;
  }
  return solver.eigenvectors().col(best).real().normalized();
}

/// (v, −v, 0), unit in the scaled space.
absl::StatusOr<Eigen::VectorXd> DoubledTangent(const Map& map, const std::vector<Point>& points) {
  const auto shot = Shoot(map, points, Derivative::kJacobian);
  if (!shot.ok()) return shot.status();
  const Eigen::Index n = map.dimension();
  const Eigen::Index half = std::ssize(points) * n;
  Eigen::VectorXd tangent = Eigen::VectorXd::Zero(2 * half + 1);
  Eigen::VectorXd v = FlipVector(CycleJacobian(*shot));
  for (Eigen::Index i = 0; i < std::ssize(points); ++i) {
    tangent.segment(i * n, n) = v;
    tangent.segment(half + i * n, n) = -v;
    v = shot->images[i].jacobian * v;
  }
  return tangent.normalized();
}

class Switch {
 public:
  Switch(const MapFamily& family, const ContinuationOptions& options, ExtendedPoint doubled,
         Eigen::VectorXd tangent)
      : equation_(EquationOf(family, options)),
        doubled_(std::move(doubled)),
        tangent_(std::move(tangent)),
        options_(options) {}

  /// Corrects at a distance from the bifurcation and, where that gives a doubled cycle, fills in
  /// the state.
  bool Try(double distance, BranchState& state) const {
    Corrected corrected = equation_.Correct(equation_.Move(doubled_, distance, tangent_), tangent_);
    state.message = corrected.cycle.message;
    if (!corrected.cycle.converged()) return false;
    BranchPoint& point = state.point;
    point.parameter = corrected.parameter;
    point.cycle = std::move(corrected.cycle);
    const auto way = equation_.Difference(Extended(point), doubled_);
    if (!way.ok() || way->dot(tangent_) < kFellBack * distance) return false;
    const auto direction = equation_.DirectionAt(Extended(point), *way);
    if (!direction.ok() || !IsClose(point.parameter, direction->tangent)) return false;
    point.tangent = direction->tangent;
    point.orientation = direction->orientation;
    point.arclength = way->norm();
    return true;
  }

 private:
  /// Not so far off that the branch has turned, or left the interval, on the way.
  bool IsClose(double parameter, const Eigen::VectorXd& tangent) const {
    const auto [low, high] = std::minmax(options_.from, options_.to);
    return parameter > low && parameter < high &&
           tangent.dot(tangent_) >= std::cos(options_.most_turn);
  }

  BranchEquation equation_;
  ExtendedPoint doubled_;
  Eigen::VectorXd tangent_;
  const ContinuationOptions& options_;
};

absl::Status CheckDoubling(const Bifurcation& doubling) {
  if (doubling.type != BifurcationType::kPeriodDoubling) {
    return absl::InvalidArgumentError(
        absl::StrCat("bifurcation: ", std::string(Name(doubling.type)),
                     " is not allowed; it is PERIOD_DOUBLING"));
  }
  const auto period = std::ssize(doubling.point.cycle.points);
  if (period >= 1 && 2 * period <= kLongestPeriod) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(
      "period: ", 2 * period, " is not allowed; it lies in [2, ", kLongestPeriod, "]"));
}

}  // namespace

absl::StatusOr<BranchState> SwitchToDoubled(const MapFamily& family,
                                            const ContinuationOptions& options,
                                            const Bifurcation& doubling) {
  if (absl::Status status = CheckContinuation(options); !status.ok()) return status;
  if (absl::Status status = CheckDoubling(doubling); !status.ok()) return status;
  const auto map = family(doubling.point.parameter);
  if (!map.ok()) return map.status();
  ExtendedPoint doubled = Extended(doubling.point);
  auto tangent = DoubledTangent(**map, doubled.points);
  if (!tangent.ok()) return tangent.status();
  const std::vector<Point> once = doubled.points;
  doubled.points.insert(doubled.points.end(), once.begin(), once.end());
  const Switch way_out(family, options, std::move(doubled), *std::move(tangent));
  BranchState state;
  for (double distance = options.initial_step; distance >= options.least_step; distance /= 2) {
    if (!way_out.Try(distance, state)) continue;
    state.step = distance;
    state.points = 1;
    state.message.clear();
    return state;
  }
  state.end = BranchEnd::kNoConvergence;
  if (state.message.empty()) state.message = "no doubled cycle was found near the bifurcation";
  return state;
}

}  // namespace celt
