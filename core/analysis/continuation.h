#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "Eigen/Core"
#include "absl/status/statusor.h"
#include "core/analysis/corrector.h"
#include "core/analysis/cycle.h"
#include "core/map/map_family.h"

namespace celt {

/// How a branch of cycles is followed. Lengths are arclengths in the scaled space of
/// core/analysis/corrector.h with scale |to − from|: a branch that moves little in the map's
/// coordinates has a length of about 1 from end to end.
struct ContinuationOptions {
  double from = 0;  ///< value of the parameter at which the branch starts
  double to = 0;    ///< where it is to end; other than `from`
  double initial_step = 0.005;
  double least_step = 1e-8;    ///< the branch is given up below
  double longest_step = 0.02;  ///< so that no two bifurcations of a kind hide in a step
  double most_turn = 0.2;      ///< [rad] between tangents of successive points
  std::int64_t most_points = 10'000;
  /// Step of the differences with respect to the parameter, as a fraction of |to − from|.
  double difference_step = 1e-3;
  NewtonOptions newton;
};

/// A point of a branch: plain data, from which the branch can be resumed.
struct BranchPoint {
  double parameter = 0;
  double arclength = 0;  ///< along the branch from its start
  CycleReport cycle;
  Eigen::VectorXd tangent;  ///< unit, scaled, in the sense of travel; the parameter comes last
  int orientation = 0;      ///< sign of det(∂R/∂y; tangentᵀ); changes where branches cross
};

/// Why a branch ended.
enum class BranchEnd {
  kNone,           ///< it goes on
  kReachedEnd,     ///< the parameter came to `to`; the last point lies there
  kReachedStart,   ///< it came back to `from`, through a fold
  kStepTooSmall,   ///< it turns so sharply that steps went below least_step
  kNoConvergence,  ///< corrections fail however small the step
  kLeftDomain,     ///< cycles leave the domain of the map or of the parameter
  kPeriodHalved,   ///< the cycle merged with one of half its period
  kMostPoints,     ///< most_points were computed
};

/// "reached the end", "came back to the start", "step too small", "no convergence", "left the
/// domain", "period halved", "most points"; "" for kNone.
std::string_view Name(BranchEnd end);

/// Where a branch stands: plain data. A branch that is resumed from a copy goes on as if it had
/// never been interrupted, to the last bit.
struct BranchState {
  BranchPoint point;        ///< the last one
  double step = 0;          ///< to try next
  std::int64_t points = 0;  ///< so far, the first included; 0 when there is no first
  BranchEnd end = BranchEnd::kNone;
  std::string message;  ///< one line on the end, where there is more to say than its name
};

/// Finds the cycle at `from` from a guess of as many points as its period, and the direction from
/// there towards `to`. When there is none the state has no points and an end that says why.
/// INVALID_ARGUMENT names an option out of range, or comes from the family or FindCycle.
absl::StatusOr<BranchState> StartBranch(const MapFamily& family, std::span<const Point> guess,
                                        const ContinuationOptions& options);

/// Takes one step of pseudo-arclength continuation (Keller 1977; Kuznetsov 2004, §10.2): predicts
/// along the tangent, corrects in the hyperplane across it, so that folds in the parameter are
/// passed. The step is halved while corrections fail or the tangent turns by more than most_turn,
/// and grows while they are easy. Afterwards either state.point is a new point or state.end is set;
/// with kReachedEnd and kReachedStart both. Precondition: state.end is kNone. Pure.
void StepBranch(const MapFamily& family, const ContinuationOptions& options, BranchState& state);

/// The equation that a branch with these options solves.
BranchEquation EquationOf(const MapFamily& family, const ContinuationOptions& options);

/// The cycle's points and parameter.
inline ExtendedPoint Extended(const BranchPoint& point) {
  return {.points = point.cycle.points, .parameter = point.parameter};
}

/// INVALID_ARGUMENT names the option out of range.
absl::Status CheckContinuation(const ContinuationOptions& options);

}  // namespace celt
