#pragma once

#include <optional>
#include <string>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/map/map_family.h"
#include "core/map/system.h"

namespace celt::plans {

/// A parameter of a system and the values between which it is varied.
struct Interval {
  std::string parameter;  ///< empty: the system's first
  std::optional<double> from;
  std::optional<double> to;
};

/// Fills in the parameter's name, and checks that the system has it, that both ends are given,
/// differ, and are values that the system takes. INVALID_ARGUMENT begins with "parameter", "from"
/// or "to".
absl::Status ResolveInterval(const System& system, const v1::JobSpec& spec, Interval& interval);

/// The specification with one parameter of its system replaced.
v1::JobSpec WithParameter(v1::JobSpec spec, const std::string& parameter, double value);

/// The maps of a resolved specification in one of its parameters. Keeps a copy of what it needs.
absl::StatusOr<MapFamily> MakeFamily(const v1::JobSpec& resolved, const std::string& parameter);

}  // namespace celt::plans
