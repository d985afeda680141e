#include "server/plans/accuracy.h"

#include <algorithm>
#include <string>

#include "absl/strings/str_format.h"
#include "core/analysis/accuracy.h"
#include "server/jobs/status_macros.h"
#include "server/plans/spec.h"

namespace celt::plans {

absl::StatusOr<std::unique_ptr<Map>> MakeReferenceMap(const v1::JobSpec& resolved) {
  constexpr double kTighter = 0.01;
  constexpr double kLooser = 10;
  constexpr double kLeast = 1e-14;
  const double tolerance = resolved.numerics().tolerance();
  v1::JobSpec spec = resolved;
  spec.mutable_numerics()->set_tolerance(tolerance > kLeast ? std::max(tolerance * kTighter, kLeast)
                                                            : tolerance * kLooser);
  return MakeMap(spec);
}

absl::StatusOr<v1::Accuracy> MeasureAccuracy(const v1::JobSpec& resolved, const Map& map,
                                             std::span<const Point> sample) {
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<Map> better, MakeReferenceMap(resolved));
  CELT_ASSIGN_OR_RETURN(const MapAccuracy measured, CompareMaps(map, *better, sample));
  v1::Accuracy accuracy;
  accuracy.set_sample(measured.sample);
  accuracy.set_map_error(measured.map_error);
  accuracy.set_jacobian_error(measured.jacobian_error);
  accuracy.set_drift(measured.drift);
  return accuracy;
}

bool IsInSample(std::int64_t index, std::int64_t count) {
  constexpr std::int64_t kSample = 16;
  const std::int64_t stride = std::max<std::int64_t>(count / kSample, 1);
  return index % stride == 0 && index / stride < kSample;
}

void WarnIfNotBelow(std::string_view quantity, double error, double standard_error,
                    v1::Accuracy& accuracy) {
  constexpr double kWellBelow = 1.0 / 3;
  if (error <= kWellBelow * standard_error) return;
  accuracy.add_warnings(absl::StrFormat(
      "%s: the error of the map gives it an error of %.1e, not well below the standard error of "
      "%.1e; a smaller tolerance helps",
      std::string(quantity), error, standard_error));
}

}  // namespace celt::plans
