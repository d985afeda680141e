#include "server/plans/lyapunov_spec.h"

#include <memory>
#include <string>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/convert.h"
#include "server/plans/lyapunov_schedule.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

constexpr std::int64_t kDefaultIterates = 100'000;
constexpr std::int32_t kDefaultOrbits = 16;
constexpr std::int64_t kDefaultTransient = 2000;
constexpr std::int32_t kMaxOrbits = 4096;

void FillIn(v1::LyapunovSpec& spec) {
  if (!spec.has_iterates()) spec.set_iterates(kDefaultIterates);
  if (!spec.has_orbits()) spec.set_orbits(kDefaultOrbits);
  if (!spec.has_transient()) spec.set_transient(kDefaultTransient);
  if (!spec.has_seed()) spec.set_seed(1);
}

absl::Status CheckNumbers(const v1::LyapunovSpec& spec) {
  CELT_RETURN_IF_ERROR(CheckRange("orbits", spec.orbits(), 1, kMaxOrbits));
  CELT_RETURN_IF_ERROR(CheckRange("iterates", spec.iterates(), spec.orbits(), kMaxIterates));
  return CheckRange("transient", spec.transient(), 0, kMaxIterates / kMaxOrbits);
}

/// Orbits may not leave the domain unnoticed at the very start.
absl::Status CheckStarts(const v1::JobSpec& spec) {
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<Map> map, MakeMap(spec));
  CELT_ASSIGN_OR_RETURN(const Point start, PointFrame(spec).ToPoint(spec.lyapunov().start()));
  CELT_RETURN_IF_ERROR(map->CheckPoint(start));
  CELT_ASSIGN_OR_RETURN(const std::vector<FramedOrbit> orbits, LyapunovStarts(spec));
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    const absl::Status status = map->CheckPoint(orbits[i].point);
    if (status.ok()) continue;
    return absl::InvalidArgumentError(absl::StrCat(status.message(), " (start of orbit ", i + 1,
                                                   ", drawn around the given start)"));
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status ResolveLyapunov(const System& system, v1::JobSpec& spec) {
  v1::LyapunovSpec& lyapunov = *spec.mutable_lyapunov();
  FillIn(lyapunov);
  CELT_RETURN_IF_ERROR(CheckNumbers(lyapunov));
  const PointFrame frame(spec);
  if (!lyapunov.has_start()) *lyapunov.mutable_start() = frame.FromPoint(system.DefaultStart());
  CELT_ASSIGN_OR_RETURN(const Point start, frame.ToPoint(lyapunov.start()));
  CELT_RETURN_IF_ERROR(CheckPoint(system, start));
  return CheckStarts(spec);
}

absl::StatusOr<std::vector<FramedOrbit>> LyapunovStarts(const v1::JobSpec& resolved) {
  CELT_ASSIGN_OR_RETURN(const System* system, FindSystem(resolved.system().name()));
  const v1::LyapunovSpec& lyapunov = resolved.lyapunov();
  CELT_ASSIGN_OR_RETURN(const Point start, PointFrame(resolved).ToPoint(lyapunov.start()));
  return DrawStarts(start, system->StartSpread(), lyapunov.orbits(), lyapunov.seed());
}

}  // namespace celt::plans
