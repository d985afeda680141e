#pragma once

#include <span>
#include <vector>

#include "absl/status/status.h"
#include "celt/v1/job.pb.h"
#include "celt/v1/lyapunov.pb.h"
#include "core/analysis/lyapunov.h"
#include "core/map/map.h"

namespace celt::plans {

v1::Condition ToCondition(const LyapunovCondition& condition);

/// A row of the convergence history: the estimate from the batches so far, none empty, at least
/// one.
v1::LyapunovRecord ToRecord(std::span<const LyapunovSums> batches);

/// The result, but for the accuracy of the map.
v1::LyapunovResult ToResult(std::span<const LyapunovSums> batches, int orbits);

/// Measures the map of a resolved specification on a sample of the orbits: its accuracy, its part
/// in the error of each exponent, and warnings where that is not well below the standard error.
absl::Status AddAccuracy(const v1::JobSpec& resolved, const Map& map,
                         std::span<const FramedOrbit> sample, v1::LyapunovResult& result);

}  // namespace celt::plans
