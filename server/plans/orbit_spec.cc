#include "server/plans/orbit_spec.h"

#include <algorithm>
#include <string>

#include "absl/strings/str_cat.h"
#include "core/map/celtic_stone_system.h"
#include "core/model/andoyer.h"
#include "server/jobs/status_macros.h"
#include "server/plans/convert.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

constexpr double kDefaultTime = 10;
constexpr double kDefaultStep = 0.01;
constexpr double kMostTime = 1e9;
constexpr double kMostStep = 1000;
constexpr double kMostTurns = 1e9;
constexpr int kStateSize = 6;

absl::Status ResolveNumbers(v1::OrbitSpec& orbit) {
  if (!orbit.has_time()) orbit.set_time(kDefaultTime);
  CELT_RETURN_IF_ERROR(CheckAbove("time", orbit.time(), 0, kMostTime));
  if (!orbit.has_step()) orbit.set_step(std::min(kDefaultStep, orbit.time()));
  CELT_RETURN_IF_ERROR(CheckAbove("step", orbit.step(), 0, std::min(kMostStep, orbit.time())));
  if (orbit.has_turns()) CELT_RETURN_IF_ERROR(CheckAbove("turns", orbit.turns(), 0, kMostTurns));
  CELT_ASSIGN_OR_RETURN(const Direction direction, ToDirection(orbit.direction()));
  orbit.set_direction(FromDirection(direction));
  CELT_ASSIGN_OR_RETURN(const OrbitOptions options, ToOrbitOptions(orbit));
  return CountRecords(options).status();
}

/// The energy of the job is that of its orbit.
absl::Status ResolveState(v1::JobSpec& spec) {
  const int size = spec.orbit().state_size();
  if (spec.orbit().has_start()) {
    return absl::InvalidArgumentError("state: not together with start; give one of the two");
  }
  if (size != kStateSize) {
    return absl::InvalidArgumentError(
        absl::StrCat("state: has ", size, " numbers where 6 are due: M and gamma"));
  }
  CELT_ASSIGN_OR_RETURN(const StoneOrbit start, OrbitStart(StoneOf(spec), spec));
  (*spec.mutable_system()->mutable_parameters())["energy"] = start.start_energy;
  return absl::OkStatus();
}

}  // namespace

CelticStone StoneOf(const v1::JobSpec& resolved) {
  return CelticStone(StoneParametersOf(ToParameters(resolved.system())));
}

absl::StatusOr<OrbitOptions> ToOrbitOptions(const v1::OrbitSpec& resolved) {
  OrbitOptions options;
  options.step = resolved.step();
  options.time = resolved.time();
  if (resolved.has_turns()) options.turns = resolved.turns();
  CELT_ASSIGN_OR_RETURN(options.direction, ToDirection(resolved.direction()));
  return options;
}

absl::StatusOr<StoneOrbit> OrbitStart(const CelticStone& stone, const v1::JobSpec& resolved) {
  const v1::OrbitSpec& orbit = resolved.orbit();
  if (orbit.state_size() == kStateSize) {
    auto start = StartOrbit(stone, StoneState(orbit.state().data()));
    if (start.ok()) return start;
    return absl::Status(start.status().code(), absl::StrCat("state: ", start.status().message()));
  }
  CELT_ASSIGN_OR_RETURN(const Point x, PointFrame(resolved).ToPoint(orbit.start()));
  const auto& parameters = resolved.system().parameters();
  CELT_ASSIGN_OR_RETURN(
      const LiftedPoint lifted,
      LiftToLevel(stone, parameters.at("energy"), parameters.at("section_angle"), SectionPoint(x)));
  return StartOrbit(stone, lifted.state);
}

absl::Status ResolveOrbit(const System& system, v1::JobSpec& spec) {
  if (system.name() != CelticStoneSystem().name()) {
    return absl::InvalidArgumentError(
        absl::StrCat("system: ", std::string(system.name()),
                     " is not allowed; orbits are of the celtic-stone, "
                     "and section has those of the maps"));
  }
  if (spec.numerics().engine() == v1::ENGINE_FAST) {
    spec.mutable_numerics()->set_engine(v1::ENGINE_ARKODE);
  }
  CELT_RETURN_IF_ERROR(CheckStone(StoneParametersOf(ToParameters(spec.system()))));
  v1::OrbitSpec& orbit = *spec.mutable_orbit();
  CELT_RETURN_IF_ERROR(ResolveNumbers(orbit));
  if (orbit.state_size() > 0) return ResolveState(spec);
  return ResolvePoint(system, spec, "start", *orbit.mutable_start());
}

}  // namespace celt::plans
