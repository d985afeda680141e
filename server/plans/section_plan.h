#pragma once

#include <cstdint>
#include <memory>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/map/system.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// An orbit of the map as one chain. Each iterate begins anew at its point, so that how the orbit
/// is cut into units does not show.

/// The most iterates that are recorded.
inline constexpr std::int64_t kMostSectionIterates = 1'000'000'000;

/// Fills in and checks `spec.section`, when everything else is resolved.
absl::Status ResolveSection(const System& system, v1::JobSpec& spec);

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeSectionPlan(const v1::JobSpec& resolved);

}  // namespace celt::plans
