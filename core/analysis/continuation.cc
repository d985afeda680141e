#include "core/analysis/continuation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace celt {
namespace {

/// Corrections that end so soon allow a longer step.
constexpr int kEasyCorrections = 4;
constexpr double kGrowth = 1.5;

/// A step that did not come off: what to say if it cannot be made smaller.
struct Failure {
  BranchEnd end = BranchEnd::kNone;
  std::string message;
};

Failure FailureOf(const CycleReport& cycle) {
  const bool lost = cycle.termination == CycleTermination::kLeftDomain;
  return {.end = lost ? BranchEnd::kLeftDomain : BranchEnd::kNoConvergence,
          .message = cycle.message};
}

/// Of BranchEquation::DirectionAt.
Failure FailureOf(const absl::Status& status) {
  const bool undefined = absl::IsFailedPrecondition(status);
  return {.end = undefined ? BranchEnd::kNoConvergence : BranchEnd::kLeftDomain,
          .message = std::string(status.message())};
}

class Stepper {
 public:
  Stepper(const MapFamily& family, const ContinuationOptions& options, const BranchState& state)
      : options_(options),
        equation_(EquationOf(family, options)),
        last_(state.point),
        start_(Extended(state.point)) {}

  /// Tries a step of the given length; nothing when it fails, for failure() to tell.
  std::optional<BranchPoint> Try(double length) {
    const ExtendedPoint predicted = equation_.Move(start_, length, last_.tangent);
    std::optional<BranchPoint> point = Complete(equation_.Correct(predicted, last_.tangent));
    if (!point || Inside(point->parameter)) return point;
    return LandOnBorder(*point);
  }

  const Failure& failure() const { return failure_; }
  double turn() const { return turn_; }

 private:
  bool Inside(double parameter) const {
    const auto [low, high] = std::minmax(options_.from, options_.to);
    return parameter > low && parameter < high;
  }

  /// The point of the branch at the border that lies between the last point and one beyond.
  std::optional<BranchPoint> LandOnBorder(const BranchPoint& beyond) {
    const auto [low, high] = std::minmax(options_.from, options_.to);
    const double border = beyond.parameter >= high ? high : low;
    const double fraction = (border - last_.parameter) / (beyond.parameter - last_.parameter);
    const auto chord = equation_.Difference(Extended(beyond), start_);
    if (!chord.ok()) return Fail(BranchEnd::kLeftDomain, std::string(chord.status().message()));
    const ExtendedPoint guess = equation_.Move(start_, fraction, *chord);
    Corrected landed = equation_.CorrectAt(border, guess.points);
    const auto miss =
        equation_.Difference({.points = landed.cycle.points, .parameter = landed.parameter}, guess);
    if (!miss.ok() || !(miss->norm() <= chord->norm())) {
      return Fail(BranchEnd::kNoConvergence, "the cycle at the border lies on another branch");
    }
    return Complete(std::move(landed));
  }

  /// Adds tangent and arclength to a corrected cycle, and refuses one that is too far round a bend.
  std::optional<BranchPoint> Complete(Corrected corrected) {
    if (!corrected.cycle.converged()) return Fail(FailureOf(corrected.cycle));
    BranchPoint point;
    point.parameter = corrected.parameter;
    point.cycle = std::move(corrected.cycle);
    const auto direction = equation_.DirectionAt(Extended(point), last_.tangent);
    const auto chord = equation_.Difference(Extended(point), start_);
    if (!direction.ok()) return Fail(FailureOf(direction.status()));
    if (!chord.ok()) return Fail(BranchEnd::kLeftDomain, std::string(chord.status().message()));
    point.tangent = direction->tangent;
    point.orientation = direction->orientation;
    point.arclength = last_.arclength + chord->norm();
    turn_ = std::acos(std::clamp(point.tangent.dot(last_.tangent), -1.0, 1.0));
    if (!(turn_ <= options_.most_turn)) {
      return Fail(BranchEnd::kStepTooSmall,
                  absl::StrCat("the branch turns too sharply at ", point.parameter));
    }
    if (PeriodHalves(point.cycle)) {
      return Fail(
          BranchEnd::kPeriodHalved,
          absl::StrCat("the cycle merges with one of half its period near ", point.parameter));
    }
    return point;
  }

  /// Whether on the way the two halves of the cycle became one, or changed places.
  bool PeriodHalves(const CycleReport& cycle) const {
    const int period = static_cast<int>(cycle.points.size());
    if (last_.cycle.minimal_period < period) return false;
    if (cycle.minimal_period < period) return true;
    if (period % 2 != 0) return false;
    return HalvesApart(cycle).dot(HalvesApart(last_.cycle)) < 0;
  }

  /// x_{k/2} − x_0, …: a stack.
  Eigen::VectorXd HalvesApart(const CycleReport& cycle) const {
    std::vector<Point> other = cycle.points;
    std::rotate(other.begin(), other.begin() + std::ssize(other) / 2, other.end());
    return *equation_.Difference({.points = other, .parameter = start_.parameter},
                                 {.points = cycle.points, .parameter = start_.parameter});
  }

  std::nullopt_t Fail(Failure failure) {
    failure_ = std::move(failure);
    return std::nullopt;
  }
  std::nullopt_t Fail(BranchEnd end, std::string message) {
    return Fail(Failure{.end = end, .message = std::move(message)});
  }

  const ContinuationOptions& options_;
  BranchEquation equation_;
  const BranchPoint& last_;
  ExtendedPoint start_;
  Failure failure_;
  double turn_ = 0;
};

BranchEnd EndAt(const BranchState& state, const ContinuationOptions& options) {
  if (state.point.parameter == options.to) return BranchEnd::kReachedEnd;
  if (state.point.parameter == options.from) return BranchEnd::kReachedStart;
  return state.points >= options.most_points ? BranchEnd::kMostPoints : BranchEnd::kNone;
}

void Accept(BranchPoint point, double length, double turn, const ContinuationOptions& options,
            BranchState& state) {
  const bool easy =
      point.cycle.iterations <= kEasyCorrections && turn * kGrowth < options.most_turn;
  state.step = easy ? std::min(kGrowth * length, options.longest_step) : length;
  state.point = std::move(point);
  ++state.points;
  state.end = EndAt(state, options);
}

absl::Status CheckPositive(const char* name, double value, double highest) {
  if (value > 0 && value <= highest) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(name, ": ", value, " is not allowed; it lies in (0, ", highest, "]"));
}

}  // namespace

std::string_view Name(BranchEnd end) {
  switch (end) {
    case BranchEnd::kNone:
      return "";
    case BranchEnd::kReachedEnd:
      return "reached the end";
    case BranchEnd::kReachedStart:
      return "came back to the start";
    case BranchEnd::kStepTooSmall:
      return "step too small";
    case BranchEnd::kNoConvergence:
      return "no convergence";
    case BranchEnd::kLeftDomain:
      return "left the domain";
    case BranchEnd::kPeriodHalved:
      return "period halved";
    case BranchEnd::kMostPoints:
      return "most points";
  }
  return "";
}

absl::Status CheckContinuation(const ContinuationOptions& options) {
  if (!std::isfinite(options.from)) {
    return absl::InvalidArgumentError(
        absl::StrCat("from: ", options.from, " is not a finite number"));
  }
  if (!std::isfinite(options.to) || options.to == options.from) {
    return absl::InvalidArgumentError(
        absl::StrCat("to: ", options.to, " is not allowed; it is a finite number other than from"));
  }
  struct Field {
    const char* name;
    double value;
    double highest;
  };
  const std::array<Field, 5> fields = {
      {{"longest_step", options.longest_step, 1},
       {"initial_step", options.initial_step, options.longest_step},
       {"least_step", options.least_step, options.initial_step},
       {"most_turn", options.most_turn, 1},
       {"difference_step", options.difference_step, 1}}};
  for (const Field& field : fields) {
    absl::Status status = CheckPositive(field.name, field.value, field.highest);
    if (!status.ok()) return status;
  }
  if (options.most_points < 2) {
    return absl::InvalidArgumentError(
        absl::StrCat("most_points: ", options.most_points, " is not allowed; it is 2 or more"));
  }
  return CheckNewton(options.newton);
}

BranchEquation EquationOf(const MapFamily& family, const ContinuationOptions& options) {
  const double scale = std::abs(options.to - options.from);
  return BranchEquation(family, scale, options.difference_step * scale, options.newton);
}

absl::StatusOr<BranchState> StartBranch(const MapFamily& family, std::span<const Point> guess,
                                        const ContinuationOptions& options) {
  if (absl::Status status = CheckContinuation(options); !status.ok()) return status;
  const auto map = family(options.from);
  if (!map.ok()) return map.status();
  auto cycle = FindCycle(**map, guess, options.newton);
  if (!cycle.ok()) return cycle.status();
  BranchState state;
  state.step = options.initial_step;
  state.point.parameter = options.from;
  state.point.cycle = *std::move(cycle);
  const auto fail = [&state](Failure failure) {
    state.end = failure.end;
    state.message = std::move(failure.message);
    return state;
  };
  if (!state.point.cycle.converged()) return fail(FailureOf(state.point.cycle));
  const Eigen::Index size = std::ssize(guess) * (*map)->dimension() + 1;
  const Eigen::VectorXd towards =
      (options.to > options.from ? 1 : -1) * Eigen::VectorXd::Unit(size, size - 1);
  const auto direction = EquationOf(family, options).DirectionAt(Extended(state.point), towards);
  if (!direction.ok()) return fail(FailureOf(direction.status()));
  state.point.tangent = direction->tangent;
  state.point.orientation = direction->orientation;
  state.points = 1;
  return state;
}

void StepBranch(const MapFamily& family, const ContinuationOptions& options, BranchState& state) {
  Stepper stepper(family, options, state);
  for (double length = state.step; length >= options.least_step; length /= 2) {
    if (auto point = stepper.Try(length)) {
      return Accept(*std::move(point), length, stepper.turn(), options, state);
    }
    // It does so however small the step.
    if (stepper.failure().end == BranchEnd::kPeriodHalved) break;
  }
  state.end = stepper.failure().end;
  state.message = stepper.failure().message;
}

}  // namespace celt
