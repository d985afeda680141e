#pragma once

#include "Eigen/Core"
#include "absl/status/status.h"
#include "core/map/map.h"
#include "core/model/celtic_stone.h"

namespace celt {

/// Tangent vectors of the flow at a state, one a column.
using StoneTangents = Eigen::Matrix<double, 6, 3>;

/// A piece of work for a SectionEngine: carry a state on the section to its next crossing.
struct CrossingTask {
  StoneState state;
  /// Used when the feed asks for derivatives; columns are carried by the flow's variational
  /// equation.
  StoneTangents tangents;
};

/// Where the flow first crosses the section again with g increasing (decreasing time: the crossing
/// before).
struct Crossing {
  StoneState state;
  /// (M, γ)̇ at the crossing, forward in time whatever the direction of travel.
  StoneState velocity;
  /// The tangents carried for the same time as the state, that is, not projected along the flow
  /// onto the section.
  StoneTangents tangents;
  /// Time taken, positive in both directions.
  double time = 0;
};

/// Where a SectionEngine gets its work and leaves its results. An engine with several lanes asks
/// for the next task as soon as a lane is free; `ticket` says which task a result belongs to.
/// Called from one thread.
class CrossingFeed {
 public:
  virtual ~CrossingFeed() = default;
  /// False when no task is ready; one may become ready after a Done.
  virtual bool Next(CrossingTask& task, int& ticket) = 0;
  /// `status`: OUT_OF_RANGE when the orbit left the domain (γ3 → 0, no crossing within the longest
  /// time allowed, more steps than allowed), with the time and the state in the message; `crossing`
  /// is then meaningless.
  virtual void Done(int ticket, const absl::Status& status, const Crossing& crossing) = 0;
};

/// Carries states of one stone on one section to their next crossings. The seam between the map,
/// which knows the section's coordinates, and the integrators, which know the flow. Immutable, safe
/// to use from many threads; each result depends on its own task alone, to the last bit.
class SectionEngine {
 public:
  virtual ~SectionEngine() = default;
  /// Works until the feed has no task left and no lane is busy.
  virtual void Run(CrossingFeed& feed, Direction direction, Derivative derivative) const = 0;
};

}  // namespace celt
