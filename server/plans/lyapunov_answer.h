#pragma once

#include <span>
#include <vector>

#include "celt/v1/lyapunov.pb.h"
#include "core/analysis/lyapunov.h"

namespace celt::plans {

/// A row of the convergence history: the estimate from all batches (none empty, at least one), its
/// standard error from those that are complete.
v1::LyapunovRecord ToRecord(std::span<const LyapunovSums> batches,
                            std::span<const LyapunovSums> complete);

/// The result, from all batches, each complete.
v1::LyapunovResult ToResult(std::span<const LyapunovSums> batches, int orbits);

}  // namespace celt::plans
