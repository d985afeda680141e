#include "core/map/system.h"

#include <array>
#include <cmath>
#include <string>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "core/map/celtic_stone_system.h"
#include "core/map/henon3d_system.h"
#include "core/map/lorenz_system.h"

namespace celt {
namespace {

constexpr double kLowestTolerance = 1e-14;
constexpr double kHighestTolerance = 1e-3;

void AppendName(std::string* out, std::string_view name) { out->append(name); }

bool IsAllowed(const ParameterInfo& info, double value) {
  // Written so that a NaN is not allowed.
  const bool above = info.lowest_allowed ? value >= info.lowest : value > info.lowest;
  const bool below = info.highest_allowed ? value <= info.highest : value < info.highest;
  return above && below && std::isfinite(value);
}

const ParameterInfo* FindParameter(const System& system, std::string_view name) {
  for (const ParameterInfo& info : system.parameters()) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

absl::Status UnknownParameter(const System& system, std::string_view name) {
  const std::string known =
      absl::StrJoin(system.parameters(), ", ",
                    [](std::string* out, const ParameterInfo& info) { out->append(info.name); });
  return absl::InvalidArgumentError(absl::StrCat(std::string(name), ": no parameter of ",
                                                 std::string(system.name()), "; it takes ", known));
}

}  // namespace

std::string RangeText(const ParameterInfo& info) {
  const bool open_below = !info.lowest_allowed || std::isinf(info.lowest);
  const bool open_above = !info.highest_allowed || std::isinf(info.highest);
  return absl::StrCat(open_below ? "(" : "[", info.lowest, ", ", info.highest,
                      open_above ? ")" : "]");
}

absl::StatusOr<Parameters> System::Resolve(const Parameters& given) const {
  Parameters resolved;
  for (const ParameterInfo& info : parameters()) resolved.emplace(info.name, info.default_value);
  for (const auto& [name, value] : given) {
    const ParameterInfo* info = FindParameter(*this, name);
    if (info == nullptr) return UnknownParameter(*this, name);
    if (!IsAllowed(*info, value)) {
      return absl::InvalidArgumentError(
          absl::StrCat(name, ": ", value, " is not allowed; it lies in ", RangeText(*info)));
    }
    resolved[name] = value;
  }
  return resolved;
}

absl::StatusOr<std::unique_ptr<Map>> System::MakeMap(const Parameters& parameters,
                                                     const Numerics& numerics) const {
  if (absl::Status status = CheckNumerics(numerics); !status.ok()) return status;
  absl::StatusOr<Parameters> resolved = Resolve(parameters);
  if (!resolved.ok()) return resolved.status();
  return Make(*resolved, numerics);
}

std::span<const System* const> AllSystems() {
  static const std::array<const System*, 3> systems = {&CelticStoneSystem(), &LorenzSystem(),
                                                       &Henon3dSystem()};
  return systems;
}

absl::StatusOr<const System*> FindSystem(std::string_view name) {
  for (const System* system : AllSystems()) {
    if (system->name() == name) return system;
  }
  const std::string known =
      absl::StrJoin(AllSystems(), ", ",
                    [](std::string* out, const System* system) { out->append(system->name()); });
  return absl::InvalidArgumentError(
      absl::StrCat("system: there is no \"", std::string(name), "\"; there are ", known));
}

absl::Status CheckNumerics(const Numerics& numerics) {
  if (numerics.tolerance >= kLowestTolerance && numerics.tolerance <= kHighestTolerance) {
    return absl::OkStatus();
  }
  return absl::InvalidArgumentError(absl::StrCat("tolerance: ", numerics.tolerance,
                                                 " is not allowed; it lies in [", kLowestTolerance,
                                                 ", ", kHighestTolerance, "]"));
}

absl::Status CheckPoint(const System& system, const Point& point) {
  const auto names = system.coordinates();
  if (point.size() != static_cast<Eigen::Index>(names.size())) {
    return absl::InvalidArgumentError(
        absl::StrCat("point: has ", point.size(), " coordinates; those of ",
                     std::string(system.name()), " are ", absl::StrJoin(names, ", ", AppendName)));
  }
  for (Eigen::Index i = 0; i < point.size(); ++i) {
    if (std::isfinite(point[i])) continue;
    return absl::InvalidArgumentError(
        absl::StrCat(std::string(names[i]), ": ", point[i], " is not a finite number"));
  }
  return absl::OkStatus();
}

}  // namespace celt
