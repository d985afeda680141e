#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/map/map.h"
#include "core/map/system.h"

namespace celt::plans {

/// The specification with every default filled in, checked as far as it can be without computing: a
/// job that fails later fails because an orbit was lost. INVALID_ARGUMENT names the field, its
/// value and what is allowed. Resolving a resolved specification changes nothing.
absl::StatusOr<v1::JobSpec> ResolveSpec(const v1::JobSpec& spec);

/// The map of a resolved specification.
absl::StatusOr<std::unique_ptr<Map>> MakeMap(const v1::JobSpec& resolved);

/// Fills in the system's known start where `point` has no coordinates, and checks that it lies in
/// the domain of the specification's map. INVALID_ARGUMENT begins with `field`. Everything but the
/// analysis must be resolved.
absl::Status ResolvePoint(const System& system, const v1::JobSpec& spec, std::string_view field,
                          v1::Point& point);

/// INVALID_ARGUMENT "field: value is not allowed; it lies in range" unless lowest ≤ value ≤
/// highest.
absl::Status CheckRange(std::string_view field, std::int64_t value, std::int64_t lowest,
                        std::int64_t highest);

/// The same of a number that is to be finite, > `above` and ≤ `highest`.
absl::Status CheckAbove(std::string_view field, double value, double above, double highest);

}  // namespace celt::plans
