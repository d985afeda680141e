#pragma once

#include <span>
#include <vector>

#include "absl/status/status.h"
#include "celt/v1/cycle.pb.h"
#include "celt/v1/manifold.pb.h"
#include "core/analysis/cycle.h"
#include "core/analysis/separatrix.h"
#include "server/plans/convert.h"

namespace celt::plans {

void AddMultipliers(std::span<const Multiplier> multipliers,
                    google::protobuf::RepeatedPtrField<v1::Multiplier>& out);

/// A cycle that was found, with its type and the paper's test.
v1::Cycle FromCycle(const CycleReport& cycle, const PointFrame& frame);

/// OK when Newton's method came to a cycle of that period. OUT_OF_RANGE: it left the map's domain;
/// NOT_FOUND: it did not converge, or came to a shorter cycle gone round several times. One line
/// with the reason, the residual and the number of iterations.
absl::Status CheckFound(const CycleReport& cycle, int period);

/// The fate of a separatrix of a saddle whose side takes so many iterates of the map.
v1::SeparatrixFate FromFate(const SeparatrixFate& fate, int iterates, const PointFrame& frame);

/// Some points of cycles at which to measure the accuracy of their map.
std::vector<Point> SampleOf(std::span<const CycleReport> cycles);

}  // namespace celt::plans
