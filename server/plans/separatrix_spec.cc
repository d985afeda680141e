#include "server/plans/separatrix_spec.h"

#include <limits>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/convert.h"
#include "server/plans/family.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

constexpr double kReturnsWidth = 1e-7;
constexpr double kTendsWidth = 1e-3;
constexpr std::int64_t kMostIterates = 10'000'000;
/// It tends to a cycle when it moves by less. Spiralling in takes a number of iterates like the
/// logarithm of this, and near the switch they are many; 1e-5 is still far inside of the basin.
constexpr double kAtRest = 1e-5;

absl::Status ResolveQuestion(v1::SeparatrixSpec& spec) {
  if (spec.question() == v1::SEPARATRIX_QUESTION_UNSPECIFIED) {
    spec.set_question(v1::SEPARATRIX_QUESTION_RETURNS);
  }
  if (v1::SeparatrixQuestion_IsValid(spec.question())) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat("question: ", static_cast<int>(spec.question()), " is not known"));
}

void FillIn(v1::SeparatrixSpec& spec) {
  const bool tends = spec.question() == v1::SEPARATRIX_QUESTION_TENDS;
  if (!spec.has_width()) spec.set_width(tends ? kTendsWidth : kReturnsWidth);
  if (!spec.has_period()) spec.set_period(1);
  if (!spec.has_side()) spec.set_side(1);
  if (!spec.has_most_iterates()) spec.set_most_iterates(SeparatrixOptions().most_iterates);
}

absl::Status CheckNumbers(const v1::SeparatrixSpec& spec) {
  CELT_RETURN_IF_ERROR(
      CheckAbove("width", spec.width(), 0, std::numeric_limits<double>::infinity()));
  CELT_RETURN_IF_ERROR(CheckRange("period", spec.period(), 1, kLongestPeriod));
  CELT_RETURN_IF_ERROR(CheckRange("most_iterates", spec.most_iterates(), 1, kMostIterates));
  if (spec.side() == 1 || spec.side() == -1) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat("side: ", spec.side(), " is not allowed; it is 1 or -1"));
}

}  // namespace

absl::Status ResolveSeparatrix(const System& system, v1::JobSpec& spec) {
  v1::SeparatrixSpec& separatrix = *spec.mutable_separatrix();
  CELT_RETURN_IF_ERROR(ResolveQuestion(separatrix));
  FillIn(separatrix);
  CELT_RETURN_IF_ERROR(CheckNumbers(separatrix));
  Interval interval = {.parameter = separatrix.parameter(), .from = {}, .to = {}};
  if (separatrix.has_from()) interval.from = separatrix.from();
  if (separatrix.has_to()) interval.to = separatrix.to();
  CELT_RETURN_IF_ERROR(ResolveInterval(system, spec, interval));
  separatrix.set_parameter(interval.parameter);
  return ResolvePoint(system, WithParameter(spec, interval.parameter, *interval.from), "near",
                      *separatrix.mutable_near());
}

absl::StatusOr<SeparatrixSearch> SeparatrixSearchOf(const v1::JobSpec& resolved) {
  const v1::SeparatrixSpec& separatrix = resolved.separatrix();
  const v1::JobSpec first = WithParameter(resolved, separatrix.parameter(), separatrix.from());
  SeparatrixSearch search;
  CELT_ASSIGN_OR_RETURN(search.guess, PointFrame(first).ToPoint(separatrix.near()));
  search.from = separatrix.from();
  search.to = separatrix.to();
  search.width = separatrix.width();
  search.period = separatrix.period();
  search.question = separatrix.question() == v1::SEPARATRIX_QUESTION_TENDS
                        ? SeparatrixQuestion::kTendsToCycle
                        : SeparatrixQuestion::kReturnsToItsSide;
  search.options.side = separatrix.side();
  search.options.most_iterates = separatrix.most_iterates();
  search.options.tolerance = kAtRest;
  return search;
}

}  // namespace celt::plans
