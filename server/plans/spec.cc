#include "server/plans/spec.h"

#include <string>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/convert.h"
#include "server/plans/lyapunov_spec.h"

namespace celt::plans {
namespace {

absl::Status ResolveSystem(const System& system, v1::System& spec) {
  CELT_ASSIGN_OR_RETURN(const Parameters resolved, system.Resolve(ToParameters(spec)));
  spec.set_name(std::string(system.name()));
  spec.mutable_parameters()->clear();
  for (const auto& [name, value] : resolved) (*spec.mutable_parameters())[name] = value;
  return absl::OkStatus();
}

absl::Status ResolveNumerics(const System& system, v1::Numerics& spec) {
  CELT_ASSIGN_OR_RETURN(const Numerics numerics, ToNumerics(spec));
  CELT_RETURN_IF_ERROR(CheckNumerics(numerics));
  spec.set_tolerance(numerics.tolerance);
  // A default may change from version to version; a specification must not.
  const bool chosen = numerics.engine != Engine::kDefault;
  spec.set_engine(FromEngine(chosen ? numerics.engine : system.DefaultEngine()));
  return absl::OkStatus();
}

absl::Status ResolveFrame(v1::JobSpec& spec) {
  switch (spec.frame()) {
    case v1::FRAME_UNSPECIFIED:
      spec.set_frame(v1::FRAME_BODY);
      return absl::OkStatus();
    case v1::FRAME_BODY:
      return absl::OkStatus();
    case v1::FRAME_PAPER:
      if (spec.system().name() == AllSystems().front()->name()) return absl::OkStatus();
      return absl::InvalidArgumentError(absl::StrCat(
          "frame: paper is not for ", spec.system().name(), ", only for celtic-stone"));
    default:
      return absl::InvalidArgumentError(
          absl::StrCat("frame: ", static_cast<int>(spec.frame()), " is not known"));
  }
}

}  // namespace

absl::Status CheckRange(std::string_view field, std::int64_t value, std::int64_t lowest,
                        std::int64_t highest) {
  if (lowest <= value && value <= highest) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(std::string(field), ": ", value,
                                                 " is not allowed; it lies in [", lowest, ", ",
                                                 highest, "]"));
}

absl::StatusOr<v1::JobSpec> ResolveSpec(const v1::JobSpec& spec) {
  v1::JobSpec resolved = spec;
  resolved.DiscardUnknownFields();
  std::string name = spec.system().name();
  if (name.empty()) name = std::string(AllSystems().front()->name());
  CELT_ASSIGN_OR_RETURN(const System* system, FindSystem(name));
  CELT_RETURN_IF_ERROR(ResolveSystem(*system, *resolved.mutable_system()));
  CELT_RETURN_IF_ERROR(ResolveNumerics(*system, *resolved.mutable_numerics()));
  CELT_RETURN_IF_ERROR(ResolveFrame(resolved));
  switch (resolved.analysis_case()) {
    case v1::JobSpec::kLyapunov:
      CELT_RETURN_IF_ERROR(ResolveLyapunov(*system, resolved));
      return resolved;
    case v1::JobSpec::ANALYSIS_NOT_SET:
      break;
  }
  return absl::InvalidArgumentError("analysis: missing; set lyapunov");
}

absl::StatusOr<std::unique_ptr<Map>> MakeMap(const v1::JobSpec& resolved) {
  CELT_ASSIGN_OR_RETURN(const System* system, FindSystem(resolved.system().name()));
  CELT_ASSIGN_OR_RETURN(const Numerics numerics, ToNumerics(resolved.numerics()));
  return system->MakeMap(ToParameters(resolved.system()), numerics);
}

}  // namespace celt::plans
