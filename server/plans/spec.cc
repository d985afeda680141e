#include "server/plans/spec.h"

#include <cmath>
#include <string>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/analysis.h"
#include "server/plans/convert.h"

namespace celt::plans {
namespace {

absl::Status ResolveSystem(const System& system, v1::System& spec) {
  if (spec.parameters().contains("")) {
    return absl::InvalidArgumentError("system.parameters: one of them has no name");
  }
  CELT_ASSIGN_OR_RETURN(const Parameters resolved, system.Resolve(ToParameters(spec)));
  spec.set_name(std::string(system.name()));
  spec.mutable_parameters()->clear();
  for (const auto& [name, value] : resolved) (*spec.mutable_parameters())[name] = value;
  return absl::OkStatus();
}

absl::Status ResolveNumerics(const System& system, double tolerance, v1::Numerics& spec) {
  if (!spec.has_tolerance()) spec.set_tolerance(tolerance);
  CELT_ASSIGN_OR_RETURN(const Numerics numerics, ToNumerics(spec));
  CELT_RETURN_IF_ERROR(CheckNumerics(numerics));
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

absl::Status CheckAbove(std::string_view field, double value, double above, double highest) {
  if (std::isfinite(value) && value > above && value <= highest) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(
      std::string(field), ": ", value, " is not allowed; it lies in (", above, ", ", highest, "]"));
}

absl::Status ResolvePoint(const System& system, const v1::JobSpec& spec, std::string_view field,
                          v1::Point& point) {
  const PointFrame frame(spec);
  const bool given =
      point.has_l() || point.has_l_over_g() || point.has_h_over_g() || point.x_size() > 0;
  if (!given) point = frame.FromPoint(system.DefaultStart());
  const auto check = [&]() -> absl::Status {
    CELT_ASSIGN_OR_RETURN(const Point x, frame.ToPoint(point));
    CELT_RETURN_IF_ERROR(CheckPoint(system, x));
    CELT_ASSIGN_OR_RETURN(const std::unique_ptr<Map> map, MakeMap(spec));
    return map->CheckPoint(x);
  };
  absl::Status status = check();
  if (status.ok()) return status;
  return absl::Status(status.code(), absl::StrCat(std::string(field), ": ", status.message()));
}

absl::StatusOr<v1::JobSpec> ResolveSpec(const v1::JobSpec& spec) {
  v1::JobSpec resolved = spec;
  resolved.DiscardUnknownFields();
  std::string name = spec.system().name();
  if (name.empty()) name = std::string(AllSystems().front()->name());
  CELT_ASSIGN_OR_RETURN(const System* system, FindSystem(name));
  CELT_RETURN_IF_ERROR(ResolveSystem(*system, *resolved.mutable_system()));
  CELT_ASSIGN_OR_RETURN(const Analysis analysis, FindAnalysis(resolved));
  CELT_RETURN_IF_ERROR(ResolveNumerics(*system, analysis.tolerance, *resolved.mutable_numerics()));
  CELT_RETURN_IF_ERROR(ResolveFrame(resolved));
  CELT_RETURN_IF_ERROR(analysis.resolve(*system, resolved));
  return resolved;
}

absl::StatusOr<std::unique_ptr<Map>> MakeMap(const v1::JobSpec& resolved) {
  CELT_ASSIGN_OR_RETURN(const System* system, FindSystem(resolved.system().name()));
  CELT_ASSIGN_OR_RETURN(const Numerics numerics, ToNumerics(resolved.numerics()));
  return system->MakeMap(ToParameters(resolved.system()), numerics);
}

}  // namespace celt::plans
