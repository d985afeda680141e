#pragma once

#include "celt/v1/hyperbolicity.pb.h"
#include "core/analysis/hyperbolicity.h"
#include "server/plans/convert.h"

namespace celt::plans {

/// The report as a message, but for the accuracy of the map. Numbers that are not finite are left
/// out.
v1::HyperbolicityResult ToResult(const HyperbolicityReport& report, const PointFrame& frame);

}  // namespace celt::plans
