#pragma once

#include <string>

#include "absl/status/statusor.h"

namespace celt::daemon {

/// A fresh token for "OWNER" or "OWNER:admin", and its line for the file of tokens, as text for a
/// person. INVALID_ARGUMENT: that is no owner.
absl::StatusOr<std::string> NewTokenText(const std::string& owner);

}  // namespace celt::daemon
