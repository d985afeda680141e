#pragma once

#include "absl/status/statusor.h"
#include "core/integrate/flow.h"
#include "core/map/map.h"
#include "core/map/system.h"

namespace celt {

/// A point that a flow carries, with tangent vectors that its variational equation carries along.
struct FlowPoint {
  Point state;
  /// n×k, one tangent vector a column, k from 0 (none are carried, and none are paid for) to n.
  SquareMatrix tangents;
};

/// Carries `start` along the flow for `time`, backward when it is negative, with tangents by Ṫ =
/// ∂f/∂x(x(t)) T.
///
/// The integrator lands on the end by a step of its own, so that no interpolation enters. The error
/// of each step, of the state and of each tangent vector alike, is held below numerics.tolerance
/// times the vector's own norm (root mean square over all components). kDefault is kArkode here: it
/// starts anew at each call, where a multistep method has to climb to its order first.
///
/// INVALID_ARGUMENT: the start is not finite, not of the flow's dimension, or outside its domain;
/// an engine that does not advance general flows. OUT_OF_RANGE: the orbit left the domain or needs
/// more than 10⁶ steps; the message has the time and the state. The result holds no NaN. Pure: safe
/// to call from many threads.
absl::StatusOr<FlowPoint> AdvanceFlow(const Flow& flow, const FlowPoint& start, double time,
                                      const Numerics& numerics);

}  // namespace celt
