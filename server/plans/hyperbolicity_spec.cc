#include "server/plans/hyperbolicity_spec.h"

#include "absl/strings/str_cat.h"
#include "core/analysis/hyperbolicity.h"
#include "server/jobs/status_macros.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

constexpr std::int64_t kMostIterates = 100'000'000;
constexpr std::int64_t kMostTransient = 1'000'000'000;
constexpr std::int64_t kLeastScout = 100;
constexpr std::int64_t kMostScout = 10'000'000;
constexpr std::int64_t kMostLmpPoints = 100'000;

void FillIn(v1::HyperbolicitySpec& spec) {
  const HyperbolicityRun defaults;
  if (!spec.has_iterates()) spec.set_iterates(defaults.iterates);
  if (!spec.has_transient()) spec.set_transient(defaults.transient);
  if (!spec.has_scout()) spec.set_scout(defaults.scout);
  if (!spec.has_seed()) spec.set_seed(1);
}

}  // namespace

absl::Status ResolveHyperbolicity(const System& system, v1::JobSpec& spec) {
  v1::HyperbolicitySpec& hyperbolicity = *spec.mutable_hyperbolicity();
  FillIn(hyperbolicity);
  const std::int64_t least = LeastIterates(HyperbolicityOptions());
  CELT_RETURN_IF_ERROR(CheckRange("iterates", hyperbolicity.iterates(), least, kMostIterates));
  CELT_RETURN_IF_ERROR(CheckRange("transient", hyperbolicity.transient(), 0, kMostTransient));
  CELT_RETURN_IF_ERROR(CheckRange("scout", hyperbolicity.scout(), kLeastScout, kMostScout));
  return ResolvePoint(system, spec, "start", *hyperbolicity.mutable_start());
}

HyperbolicityOptions HyperbolicityOptionsOf(const v1::HyperbolicitySpec& resolved) {
  HyperbolicityOptions options;
  options.lmp_stride = (resolved.iterates() + kMostLmpPoints - 1) / kMostLmpPoints;
  return options;
}

}  // namespace celt::plans
