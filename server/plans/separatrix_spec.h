#pragma once

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/analysis/separatrix.h"
#include "core/map/system.h"

namespace celt::plans {

/// Fills in and checks `spec.separatrix`, when everything else is resolved.
absl::Status ResolveSeparatrix(const System& system, v1::JobSpec& spec);

/// Of a resolved specification.
absl::StatusOr<SeparatrixSearch> SeparatrixSearchOf(const v1::JobSpec& resolved);

}  // namespace celt::plans
