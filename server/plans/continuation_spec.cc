#include "server/plans/continuation_spec.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/family.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

constexpr double kShortestStep = 1e-6;
constexpr std::int64_t kMostPoints = 100'000;
constexpr int kMostDoublings = 8;

void FillIn(v1::ContinuationSpec& spec) {
  const ContinuationOptions options;
  if (!spec.has_period()) spec.set_period(1);
  if (!spec.has_longest_step()) spec.set_longest_step(options.longest_step);
  if (!spec.has_most_points()) spec.set_most_points(options.most_points);
  if (!spec.has_doublings()) spec.set_doublings(0);
}

absl::Status CheckNumbers(const v1::ContinuationSpec& spec) {
  CELT_RETURN_IF_ERROR(CheckRange("period", spec.period(), 1, kLongestPeriod));
  CELT_RETURN_IF_ERROR(CheckRange("most_points", spec.most_points(), 2, kMostPoints));
  CELT_RETURN_IF_ERROR(CheckRange("doublings", spec.doublings(), 0, kMostDoublings));
  const double step = spec.longest_step();
  if (std::isfinite(step) && step >= kShortestStep && step <= 1) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat("longest_step: ", step, " is not allowed; it lies in [", kShortestStep, ", 1]"));
}

absl::Status ResolveEnds(const System& system, v1::JobSpec& spec) {
  v1::ContinuationSpec& continuation = *spec.mutable_continuation();
  Interval interval = {.parameter = continuation.parameter(), .from = {}, .to = {}};
  if (continuation.has_from()) interval.from = continuation.from();
  if (continuation.has_to()) interval.to = continuation.to();
  const auto& parameters = spec.system().parameters();
  const std::string& name = interval.parameter.empty()
                                ? std::string(system.parameters().front().name)
                                : interval.parameter;
  const auto own = parameters.find(name);
  if (!interval.from && own != parameters.end()) interval.from = own->second;
  CELT_RETURN_IF_ERROR(ResolveInterval(system, spec, interval));
  continuation.set_parameter(interval.parameter);
  continuation.set_from(*interval.from);
  return absl::OkStatus();
}

}  // namespace

absl::Status ResolveContinuation(const System& system, v1::JobSpec& spec) {
  v1::ContinuationSpec& continuation = *spec.mutable_continuation();
  FillIn(continuation);
  CELT_RETURN_IF_ERROR(CheckNumbers(continuation));
  CELT_RETURN_IF_ERROR(ResolveEnds(system, spec));
  return ResolvePoint(system, WithParameter(spec, continuation.parameter(), continuation.from()),
                      "near", *continuation.mutable_near());
}

ContinuationOptions OptionsOf(const v1::ContinuationSpec& spec) {
  ContinuationOptions options;
  options.from = spec.from();
  options.to = spec.to();
  options.longest_step = spec.longest_step();
  options.initial_step = std::min(options.initial_step, options.longest_step);
  options.most_points = spec.most_points();
  return options;
}

}  // namespace celt::plans
