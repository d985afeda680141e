#pragma once

#include "absl/status/status.h"
#include "celt/v1/job.pb.h"
#include "core/analysis/hyperbolicity_sums.h"
#include "core/map/system.h"

namespace celt::plans {

/// Fills in and checks `spec.hyperbolicity`, when everything else is resolved.
absl::Status ResolveHyperbolicity(const System& system, v1::JobSpec& spec);

/// Of a resolved specification. At most 100000 points go to the LMP graph.
HyperbolicityOptions HyperbolicityOptionsOf(const v1::HyperbolicitySpec& resolved);

}  // namespace celt::plans
