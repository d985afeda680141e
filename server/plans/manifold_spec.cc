#include "server/plans/manifold_spec.h"

#include <numbers>

#include "core/analysis/cycle.h"
#include "server/jobs/status_macros.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

constexpr std::int64_t kDefaultPoints = 200'000;
constexpr std::int64_t kMostPoints = 1'000'000;
constexpr double kMostLength = 1e6;
/// Just below pi, at which a polygon turns straight back.
constexpr double kMostTurning = 3.14;

void FillIn(v1::ManifoldSpec& spec) {
  const ManifoldOptions defaults;
  if (!spec.has_period()) spec.set_period(1);
  if (!spec.has_length()) spec.set_length(defaults.length);
  if (!spec.has_spacing()) spec.set_spacing(defaults.most_spacing);
  if (!spec.has_turning()) spec.set_turning(defaults.most_turning);
  if (!spec.has_most_points()) spec.set_most_points(kDefaultPoints);
}

}  // namespace

absl::Status ResolveManifold(const System& system, v1::JobSpec& spec) {
  v1::ManifoldSpec& manifold = *spec.mutable_manifold();
  FillIn(manifold);
  CELT_RETURN_IF_ERROR(CheckRange("period", manifold.period(), 1, kLongestPeriod));
  CELT_RETURN_IF_ERROR(CheckAbove("length", manifold.length(), 0, kMostLength));
  CELT_RETURN_IF_ERROR(CheckAbove("spacing", manifold.spacing(), 0, kMostLength));
  CELT_RETURN_IF_ERROR(CheckAbove("turning", manifold.turning(), 0, kMostTurning));
  CELT_RETURN_IF_ERROR(CheckRange("most_points", manifold.most_points(), 2, kMostPoints));
  return ResolvePoint(system, spec, "near", *manifold.mutable_near());
}

ManifoldOptions ManifoldOptionsOf(const v1::JobSpec& resolved) {
  const v1::ManifoldSpec& manifold = resolved.manifold();
  const v1::Engine engine = resolved.numerics().engine();
  const bool slow = engine == v1::ENGINE_CVODE || engine == v1::ENGINE_ARKODE;
  ManifoldOptions options;
  options.length = manifold.length();
  options.most_spacing = manifold.spacing();
  options.most_turning = manifold.turning();
  // A bend as sharp as that is cut by a tenth of the spacing and less.
  options.most_turning_by_spacing = options.most_spacing / 10;
  options.most_points = manifold.most_points();
  if (slow) options.most_iterates = 500;
  return options;
}

}  // namespace celt::plans
