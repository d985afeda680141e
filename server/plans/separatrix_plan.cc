#include "server/plans/separatrix_plan.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/accuracy.h"
#include "server/plans/chain_plan.h"
#include "server/plans/convert.h"
#include "server/plans/convert_cycle.h"
#include "server/plans/family.h"
#include "server/plans/separatrix_spec.h"
#include "server/plans/separatrix_state.h"
#include "server/plans/serialize.h"

namespace celt::plans {
namespace {

/// Values that a bisection looks at: doubles between any two run out after so many halvings.
constexpr int kMostHalvings = 2200;

class SeparatrixPlan final : public ChainPlan {
 public:
  SeparatrixPlan(const v1::JobSpec& resolved, MapFamily family, SeparatrixSearch search)
      : spec_(resolved), family_(std::move(family)), search_(std::move(search)) {}

  jobs::Work work() const override {
    const double halvings = std::log2(std::abs(search_.to - search_.from) / search_.width);
    return {.total = 2 + std::max(0.0, std::ceil(halvings)), .unit = "values"};
  }

 private:
  std::int64_t MostSteps() const override { return 2 + kMostHalvings; }

  absl::StatusOr<Stretch> Advance(std::string_view state,
                                  const jobs::StopRequested& stop) const override {
    CELT_ASSIGN_OR_RETURN(SeparatrixBisection bisection, DecodeBisection(state));
    const std::size_t ends = bisection.ends.size();
    const absl::Status status =
        StepBisection(family_, search_, bisection, [&stop](std::int64_t) { return !stop(); });
    // What is found in computing is no fault of the specification's form.
    const absl::Status failure =
        absl::IsInvalidArgument(status) ? absl::FailedPreconditionError(status.message()) : status;
    const bool looked = status.ok() || bisection.ends.size() > ends;
    if (!looked) return failure;
    Stretch stretch;
    stretch.error = failure;
    stretch.records.push_back(Record(bisection.last));
    stretch.state = stretch.summary = EncodeBisection(bisection);
    stretch.work = 1;
    stretch.ended = bisection.done;
    return stretch;
  }

  absl::StatusOr<v1::Result> MakeResult(std::string_view known) const override;

  PointFrame FrameAt(double value) const {
    return PointFrame(WithParameter(spec_, spec_.separatrix().parameter(), value));
  }
  v1::Record Record(const SeparatrixProbe& probe) const;
  absl::StatusOr<v1::Accuracy> AccuracyAt(const SeparatrixProbe& probe) const;

  const v1::JobSpec spec_;
  const MapFamily family_;
  const SeparatrixSearch search_;
};

v1::Record SeparatrixPlan::Record(const SeparatrixProbe& probe) const {
  v1::Record record;
  v1::SeparatrixRecord& out = *record.mutable_separatrix();
  out.set_value(probe.value);
  out.set_answer(probe.answer);
  *out.mutable_fate() = FromFate(probe.fate, probe.iterates, FrameAt(probe.value));
  return record;
}

absl::StatusOr<v1::Accuracy> SeparatrixPlan::AccuracyAt(const SeparatrixProbe& probe) const {
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<Map> map, family_(probe.value));
  return MeasureAccuracy(WithParameter(spec_, spec_.separatrix().parameter(), probe.value), *map,
                         {&probe.saddle, 1});
}

absl::StatusOr<v1::Result> SeparatrixPlan::MakeResult(std::string_view known) const {
  CELT_ASSIGN_OR_RETURN(const SeparatrixBisection bisection, DecodeBisection(known));
  if (bisection.ends.size() != 2) {
    return absl::DataLossError("the stored state of the bisection is damaged");
  }
  const SeparatrixBracket bracket = BracketOf(bisection);
  const int iterates = bisection.last.iterates;
  v1::Result result;
  v1::SeparatrixResult& out = *result.mutable_separatrix();
  out.set_value(bracket.yes + (bracket.no - bracket.yes) / 2);
  out.set_error(std::abs(bracket.no - bracket.yes) / 2);
  out.set_yes(bracket.yes);
  out.set_no(bracket.no);
  *out.mutable_yes_fate() = FromFate(bracket.yes_fate, iterates, FrameAt(bracket.yes));
  *out.mutable_no_fate() = FromFate(bracket.no_fate, iterates, FrameAt(bracket.no));
  *out.mutable_saddle() = FrameAt(bisection.last.value).FromPoint(bracket.saddle);
  CELT_ASSIGN_OR_RETURN(*out.mutable_accuracy(), AccuracyAt(bisection.last));
  if (bracket.no_fate.end == SeparatrixEnd::kUndecided &&
      search_.question == SeparatrixQuestion::kTendsToCycle) {
    out.mutable_accuracy()->add_warnings(absl::StrCat(
        "the fate at ", bracket.no, " is undecided after ", search_.options.most_iterates,
        " iterates: the switch may lie beyond; most_iterates decides"));
  }
  return result;
}

}  // namespace

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeSeparatrixPlan(const v1::JobSpec& resolved) {
  CELT_ASSIGN_OR_RETURN(MapFamily family, MakeFamily(resolved, resolved.separatrix().parameter()));
  CELT_ASSIGN_OR_RETURN(SeparatrixSearch search, SeparatrixSearchOf(resolved));
  return std::make_unique<SeparatrixPlan>(resolved, std::move(family), std::move(search));
}

}  // namespace celt::plans
