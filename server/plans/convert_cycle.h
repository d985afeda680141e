#pragma once

#include <span>

#include "celt/v1/cycle.pb.h"
#include "core/analysis/cycle.h"
#include "server/plans/convert.h"

namespace celt::plans {

void AddMultipliers(std::span<const Multiplier> multipliers,
                    google::protobuf::RepeatedPtrField<v1::Multiplier>& out);

/// A cycle that was found, with its type and the paper's test.
v1::Cycle FromCycle(const CycleReport& cycle, const PointFrame& frame);

}  // namespace celt::plans
