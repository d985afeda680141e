#pragma once

#include <cstdint>
#include <limits>

#include "absl/status/status.h"
#include "celt/v1/job.pb.h"

namespace celt::plans {

/// What one job may ask for. By default, whatever specifications allow.
struct SpecLimits {
  static constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::max();
  std::int64_t iterates = kNone;  ///< in all, transients and every node of a sweep counted
  std::int64_t nodes = kNone;     ///< of a sweep
  std::int64_t records = kNone;   ///< as far as the specification tells their number
};

/// INVALID_ARGUMENT names the field of a resolved specification by which it asks for more, and the
/// limit.
absl::Status CheckLimits(const v1::JobSpec& resolved, const SpecLimits& limits);

}  // namespace celt::plans
