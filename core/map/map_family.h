#pragma once

#include <functional>
#include <memory>

#include "absl/status/statusor.h"
#include "core/map/map.h"

namespace celt {

/// Maps that depend on a parameter: the map at a value of it, or the status of making it (a value
/// out of range is INVALID_ARGUMENT). Pure and safe to call from many threads.
using MapFamily = std::function<absl::StatusOr<std::unique_ptr<Map>>(double parameter)>;

}  // namespace celt
