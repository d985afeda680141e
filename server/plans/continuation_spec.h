#pragma once

#include "absl/status/status.h"
#include "celt/v1/job.pb.h"
#include "core/analysis/continuation.h"
#include "core/map/system.h"

namespace celt::plans {

/// Fills in and checks `spec.continuation`, when everything else is resolved.
absl::Status ResolveContinuation(const System& system, v1::JobSpec& spec);

/// Of a resolved specification.
ContinuationOptions OptionsOf(const v1::ContinuationSpec& spec);

}  // namespace celt::plans
