#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/map/map.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// What a sweep asks of the analysis at a node, whatever analysis it is.

/// Resolves the node's own job: its starts must lie in its own map's domain.
absl::Status ResolveNode(v1::JobSpec& node);

/// The work of a node's plan, in its own unit; 0 when its plan can't be made.
double NodeWork(v1::JobSpec node);

/// Runs the node's job; `record` gets the answer, or the reason why there is none. CANCELLED when
/// `stop` says so; no other failure.
absl::Status RunNode(v1::JobSpec node, const jobs::StopRequested& stop, v1::SweepRecord& record);

/// Whether the analysis follows an orbit from a start, so that an attractor can be carried along.
bool FollowsOrbit(const v1::JobSpec& node);

/// Puts the node's start at a point of its map.
void SetStart(const Point& start, v1::JobSpec& node);

/// Where the orbit from the node's start is after the transient and an orbit's share of the
/// iterates. The node must be resolved. OUT_OF_RANGE: it is lost on the way.
absl::StatusOr<Point> CarryOn(const v1::JobSpec& node, const jobs::StopRequested& stop);

}  // namespace celt::plans
