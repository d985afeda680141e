#include "core/analysis/cycle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "Eigen/LU"
#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace celt {
namespace {

/// Below this reciprocal condition number a solution has no correct digit.
constexpr double kSingular = 1e-15;
/// Points of a cycle closer than this are one point.
constexpr double kSamePoint = 1e-7;
/// The map's own error keeps corrections from shrinking: within this factor of the tolerance that
/// is the end of what can be had, and `correction` says so.
constexpr double kStagnation = 1e3;

double LargestNorm(const Eigen::VectorXd& stack, Eigen::Index dimension) {
  double largest = 0;
  for (Eigen::Index row = 0; row < stack.size(); row += dimension) {
    largest = std::max(largest, stack.segment(row, dimension).norm());
  }
  return largest;
}

int MinimalPeriod(const Map& map, std::span<const Point> points) {
  const auto period = static_cast<int>(points.size());
  for (int d = 1; d < period; ++d) {
    if (period % d != 0) continue;
    double distance = 0;
    for (int i = 0; i < period; ++i) {
      distance = std::max(distance, map.Difference(points[(i + d) % period], points[i]).norm());
    }
    if (distance < kSamePoint) return d;
  }
  return period;
}

class Newton {
 public:
  Newton(const Map& map, const NewtonOptions& options, CycleReport& report)
      : map_(map), options_(options), report_(report) {}

  /// Works from report.points, whose shot is given, until an end is reached.
  absl::Status Run(Shot shot) {
    shot_ = std::move(shot);
    while (report_.iterations < options_.max_iterations) {
      if (!ComputeCorrection()) return End(CycleTermination::kSingular, "DF^k - 1 is singular");
      if (report_.correction <= options_.tolerance) return Finish();
      if (!TakeDampedStep()) {
        if (report_.correction <= kStagnation * options_.tolerance) return Finish();
        return GiveUp();
      }
    }
    return End(CycleTermination::kNoConvergence,
               absl::StrCat("no convergence in ", options_.max_iterations, " iterations"));
  }

 private:
  bool ComputeCorrection() {
    lu_.compute(ShootingJacobian(shot_));
    if (!(lu_.rcond() > kSingular)) return false;
    correction_ = -lu_.solve(shot_.residual);
    if (!correction_.allFinite()) return false;
    report_.correction = correction_.norm();
    ++report_.iterations;
    return true;
  }

  bool TakeDampedStep() {
    for (double damping = std::min(1.0, 4 * damping_); damping >= options_.least_damping;
         damping /= 2) {
      std::vector<Point> trial = Displaced(report_.points, damping, correction_);
      auto shot = Shoot(map_, trial, Derivative::kJacobian);
      trial_status_ = shot.status();
      if (!shot.ok()) continue;
      const double next = lu_.solve(shot->residual).norm();
      if (!(next <= (1 - damping / 4) * report_.correction)) continue;
      damping_ = damping;
      report_.points = std::move(trial);
      shot_ = *std::move(shot);
      return true;
    }
    return false;
  }

  absl::Status Finish() {
    const std::vector<Point> points = Displaced(report_.points, 1, correction_);
    auto described = DescribeCycle(map_, points);
    if (!described.ok())
      return End(CycleTermination::kLeftDomain, std::string(described.status().message()));
    described->iterations = report_.iterations;
    described->correction = report_.correction;
    report_ = *std::move(described);
    return absl::OkStatus();
  }

  absl::Status GiveUp() {
    if (!trial_status_.ok()) {
      return End(CycleTermination::kLeftDomain, std::string(trial_status_.message()));
    }
    return End(CycleTermination::kNoConvergence,
               absl::StrCat("no convergence: no fraction of the correction of length ",
                            report_.correction, " leads to a shorter one"));
  }

  absl::Status End(CycleTermination termination, std::string message) {
    report_.termination = termination;
    report_.message = std::move(message);
    report_.residual = LargestNorm(shot_.residual, map_.dimension());
    return absl::OkStatus();
  }

  const Map& map_;
  const NewtonOptions& options_;
  CycleReport& report_;
  Shot shot_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  Eigen::VectorXd correction_;
  absl::Status trial_status_;
  double damping_ = 1;
};

absl::Status CheckPeriod(std::int64_t period) {
  if (period >= 1 && period <= kLongestPeriod) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat("period: ", period, " is not allowed; it lies in [1, ", kLongestPeriod, "]"));
}

CycleReport LostGuess(std::vector<Point> points, const absl::Status& status) {
  CycleReport report;
  report.termination = CycleTermination::kLeftDomain;
  report.message = absl::StrCat("the orbit of the guess: ", std::string(status.message()));
  report.points = std::move(points);
  return report;
}

}  // namespace

std::string_view Name(CycleTermination termination) {
  switch (termination) {
    case CycleTermination::kConverged:
      return "converged";
    case CycleTermination::kNoConvergence:
      return "no convergence";
    case CycleTermination::kLeftDomain:
      return "left the domain";
    case CycleTermination::kSingular:
      return "singular";
  }
  return "";
}

absl::Status CheckNewton(const NewtonOptions& options) {
  // Written so that a NaN is refused.
  if (!(options.tolerance > 0 && options.tolerance <= 1)) {
    return absl::InvalidArgumentError(
        absl::StrCat("tolerance: ", options.tolerance, " is not allowed; it lies in (0, 1]"));
  }
  if (options.max_iterations < 1 || options.max_iterations > 10000) {
    return absl::InvalidArgumentError(absl::StrCat("max_iterations: ", options.max_iterations,
                                                   " is not allowed; it lies in [1, 10000]"));
  }
  if (!(options.least_damping > 0 && options.least_damping <= 1)) {
    return absl::InvalidArgumentError(absl::StrCat("least_damping: ", options.least_damping,
                                                   " is not allowed; it lies in (0, 1]"));
  }
  return absl::OkStatus();
}

absl::StatusOr<CycleReport> DescribeCycle(const Map& map, std::span<const Point> points) {
  const auto shot = Shoot(map, points, Derivative::kJacobian);
  if (!shot.ok()) return shot.status();
  CycleReport report;
  report.termination = CycleTermination::kConverged;
  report.points = InMapsRange(map, points, *shot);
  report.residual = LargestNorm(shot->residual, map.dimension());
  report.minimal_period = MinimalPeriod(map, report.points);
  report.return_time = TotalTime(*shot);
  report.multipliers = MultipliersOf(CycleJacobian(*shot));
  return report;
}

absl::StatusOr<CycleReport> FindCycle(const Map& map, std::span<const Point> guess,
                                      const NewtonOptions& options) {
  if (absl::Status status = CheckNewton(options); !status.ok()) return status;
  if (absl::Status status = CheckPeriod(std::ssize(guess)); !status.ok()) return status;
  for (const Point& point : guess) {
    if (absl::Status status = map.CheckPoint(point); !status.ok()) return status;
  }
  auto shot = Shoot(map, guess, Derivative::kJacobian);
  std::vector<Point> points(guess.begin(), guess.end());
  if (absl::IsOutOfRange(shot.status())) return LostGuess(std::move(points), shot.status());
  if (!shot.ok()) return shot.status();
  CycleReport report;
  report.points = std::move(points);
  if (absl::Status status = Newton(map, options, report).Run(*std::move(shot)); !status.ok()) {
    return status;
  }
  return report;
}

absl::StatusOr<CycleReport> FindCycle(const Map& map, const Point& guess, int period,
                                      const NewtonOptions& options) {
  if (absl::Status status = CheckPeriod(period); !status.ok()) return status;
  if (absl::Status status = map.CheckPoint(guess); !status.ok()) return status;
  std::vector<Point> points = {guess};
  while (std::ssize(points) < period) {
    const auto image = map.Apply(points.back(), Direction::kForward, Derivative::kNone);
    if (absl::IsInvalidArgument(image.status()) && points.size() == 1) return image.status();
    if (!image.ok()) return LostGuess(std::move(points), image.status());
    points.push_back(image->point);
  }
  return FindCycle(map, points, options);
}

}  // namespace celt
