#include "server/plans/family.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "server/jobs/status_macros.h"
#include "server/plans/convert.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

absl::Status CheckName(const System& system, const std::string& name) {
  const auto known = system.parameters();
  if (std::any_of(known.begin(), known.end(),
                  [&name](const ParameterInfo& info) { return info.name == name; })) {
    return absl::OkStatus();
  }
  const auto write = [](std::string* out, const ParameterInfo& info) { out->append(info.name); };
  return absl::InvalidArgumentError(
      absl::StrCat("parameter: '", name, "' is none of ", std::string(system.name()),
                   ", which has ", absl::StrJoin(known.begin(), known.end(), ", ", write)));
}

absl::Status CheckEnd(const v1::JobSpec& spec, const char* field, const Interval& interval,
                      const std::optional<double>& value) {
  if (!value) return absl::InvalidArgumentError(absl::StrCat(field, ": missing"));
  const auto map = MakeMap(WithParameter(spec, interval.parameter, *value));
  if (map.ok()) return absl::OkStatus();
  return absl::Status(map.status().code(), absl::StrCat(field, ": ", map.status().message()));
}

}  // namespace

absl::Status ResolveInterval(const System& system, const v1::JobSpec& spec, Interval& interval) {
  if (interval.parameter.empty()) {
    interval.parameter = std::string(system.parameters().front().name);
  }
  CELT_RETURN_IF_ERROR(CheckName(system, interval.parameter));
  CELT_RETURN_IF_ERROR(CheckEnd(spec, "from", interval, interval.from));
  CELT_RETURN_IF_ERROR(CheckEnd(spec, "to", interval, interval.to));
  if (*interval.from != *interval.to) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat("to: ", *interval.to,
                                                 " is not allowed; it is a value of ",
                                                 interval.parameter, " other than from"));
}

v1::JobSpec WithParameter(v1::JobSpec spec, const std::string& parameter, double value) {
  (*spec.mutable_system()->mutable_parameters())[parameter] = value;
  return spec;
}

absl::StatusOr<MapFamily> MakeFamily(const v1::JobSpec& resolved, const std::string& parameter) {
  CELT_ASSIGN_OR_RETURN(const System* system, FindSystem(resolved.system().name()));
  CELT_ASSIGN_OR_RETURN(const Numerics numerics, ToNumerics(resolved.numerics()));
  return MapFamily(
      [system, numerics, parameter, others = ToParameters(resolved.system())](double value) {
        Parameters parameters = others;
        parameters[parameter] = value;
        return system->MakeMap(parameters, numerics);
      });
}

}  // namespace celt::plans
