#include "server/plans/continuation_plan.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "absl/strings/str_cat.h"
#include "core/analysis/branch.h"
#include "core/analysis/branch_switch.h"
#include "server/jobs/status_macros.h"
#include "server/plans/accuracy.h"
#include "server/plans/branch_state.h"
#include "server/plans/chain_plan.h"
#include "server/plans/continuation_known.h"
#include "server/plans/continuation_spec.h"
#include "server/plans/convert.h"
#include "server/plans/convert_branch.h"
#include "server/plans/convert_cycle.h"
#include "server/plans/cycle_state.h"
#include "server/plans/family.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"
#include "server/plans/state.pb.h"

namespace celt::plans {
namespace {

constexpr double kPercent = 100;  // of a branch, the unit of work
/// Images of a unit's cycles: a point of a branch takes some twenty of each, a bifurcation more.
constexpr std::int64_t kUnitPoints = 16;

/// A unit begins a branch, or goes on along it.
class ContinuationPlan final : public ChainPlan {
 public:
  ContinuationPlan(const v1::JobSpec& resolved, MapFamily family, Point guess)
      : spec_(resolved),
        continuation_(resolved.continuation()),
        options_(OptionsOf(continuation_)),
        converter_(resolved),
        family_(std::move(family)),
        guess_(std::move(guess)) {}

  jobs::Work work() const override {
    return {.total = kPercent * (1 + continuation_.doublings()), .unit = "percent"};
  }

 private:
  std::int64_t MostSteps() const override {
    return (1 + continuation_.doublings()) * (continuation_.most_points() / UnitPoints() + 3);
  }
  absl::StatusOr<Stretch> Advance(std::string_view state,
                                  const jobs::StopRequested& stop) const override;
  absl::StatusOr<std::string> Fold(std::string_view known,
                                   std::string_view summary) const override {
    CELT_ASSIGN_OR_RETURN(const auto found, Parse<v1::ContinuationResult>(summary));
    return FoldContinuation(known, found);
  }
  absl::StatusOr<v1::Result> MakeResult(std::string_view known) const override {
    v1::Result result;
    CELT_ASSIGN_OR_RETURN(*result.mutable_continuation(), KnownContinuation(known));
    return result;
  }

  std::int64_t UnitPoints() const {
    return std::max<std::int64_t>(1, kUnitPoints / continuation_.period());
  }

  /// A unit under way.
  struct Unit {
    ContinuationState state;
    BranchState branch;
    Stretch stretch;
    v1::ContinuationResult found;
  };
  absl::StatusOr<BranchState> BeginFirst() const;
  absl::StatusOr<BranchState> BeginDoubled(const DoublingState& doubling) const;
  absl::Status Begin(Unit& unit) const;
  absl::Status Go(Unit& unit, const jobs::StopRequested& stop) const;
  absl::Status End(Unit& unit) const;
  void AddPoint(Unit& unit) const;
  void AddBifurcation(const Bifurcation& bifurcation, Unit& unit) const;
  void CountWork(double fraction, Unit& unit) const;

  const v1::JobSpec spec_;
  const v1::ContinuationSpec continuation_;
  const ContinuationOptions options_;
  const BranchConverter converter_;
  const MapFamily family_;
  const Point guess_;
};

absl::StatusOr<BranchState> ContinuationPlan::BeginFirst() const {
  const auto at = [this](const absl::Status& status) {
    return absl::Status(status.code(), absl::StrCat("at ", continuation_.parameter(), " ",
                                                    options_.from, ": ", status.message()));
  };
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<Map> map, family_(options_.from));
  const auto cycle = FindCycle(*map, guess_, continuation_.period(), options_.newton);
  if (!cycle.ok()) return at(cycle.status());
  if (absl::Status found = CheckFound(*cycle, continuation_.period()); !found.ok()) {
    return at(found);
  }
  CELT_ASSIGN_OR_RETURN(BranchState branch, StartBranch(family_, cycle->points, options_));
  if (branch.points > 0) return branch;
  return at(absl::NotFoundError(
      absl::StrCat("no branch begins: ", std::string(Name(branch.end)), ": ", branch.message)));
}

/// A branch that can't be entered is one that has ended.
absl::StatusOr<BranchState> ContinuationPlan::BeginDoubled(const DoublingState& doubling) const {
  Bifurcation bifurcation;
  bifurcation.type = BifurcationType::kPeriodDoubling;
  bifurcation.point.parameter = doubling.parameter();
  CELT_ASSIGN_OR_RETURN(bifurcation.point.cycle, FromState(doubling.cycle()));
  absl::StatusOr<BranchState> branch = SwitchToDoubled(family_, options_, bifurcation);
  if (branch.ok() && branch->points > 0) return branch;
  BranchState none;
  none.point = bifurcation.point;
  none.end = branch.ok() ? branch->end : BranchEnd::kNoConvergence;
  none.message = branch.ok() ? branch->message : std::string(branch.status().message());
  return none;
}

absl::Status ContinuationPlan::Begin(Unit& unit) const {
  ContinuationState& state = unit.state;
  if (state.branch() == 0) {
    CELT_ASSIGN_OR_RETURN(unit.branch, BeginFirst());
  } else {
    CELT_ASSIGN_OR_RETURN(unit.branch, BeginDoubled(state.doublings(0)));
    state.mutable_doublings()->DeleteSubrange(0, 1);
  }
  state.set_following(true);
  state.set_from(unit.branch.point.parameter);
  state.set_reached(0);
  if (unit.branch.points > 0) AddPoint(unit);
  return absl::OkStatus();
}

void ContinuationPlan::AddPoint(Unit& unit) const {
  v1::Record record = converter_.PointRecord(unit.state.branch(), unit.branch.point);
  v1::BranchPoint& shown = *unit.found.add_branch();
  shown = record.continuation().point();
  shown.mutable_cycle()->clear_lorenz_conditions();
  unit.stretch.records.push_back(std::move(record));
}

void ContinuationPlan::AddBifurcation(const Bifurcation& bifurcation, Unit& unit) const {
  v1::Record record = converter_.BifurcationRecord(unit.state.branch(), bifurcation);
  *unit.found.add_bifurcations() = record.continuation().bifurcation();
  unit.stretch.records.push_back(std::move(record));
  ContinuationState& state = unit.state;
  const bool doubles = bifurcation.type == BifurcationType::kPeriodDoubling &&
                       2 * std::ssize(bifurcation.point.cycle.points) <= kLongestPeriod;
  if (!doubles || state.branch() + state.doublings_size() >= continuation_.doublings()) return;
  DoublingState& doubling = *state.add_doublings();
  *doubling.mutable_cycle() = ToState(bifurcation.point.cycle);
  doubling.set_parameter(bifurcation.point.parameter);
}

void ContinuationPlan::CountWork(double fraction, Unit& unit) const {
  const double more = std::clamp(fraction, 0.0, 1.0) - unit.state.reached();
  if (!(more > 0)) return;
  unit.stretch.work += kPercent * more;
  unit.state.set_reached(unit.state.reached() + more);
}

/// Point by point, so that what happened on the way to a point comes before it.
absl::Status ContinuationPlan::Go(Unit& unit, const jobs::StopRequested& stop) const {
  BranchState& branch = unit.branch;
  for (std::int64_t i = 0; i < UnitPoints() && branch.end == BranchEnd::kNone; ++i) {
    const auto step = AdvanceBranch(family_, options_, branch, 1, [&stop] { return !stop(); });
    if (absl::IsCancelled(step.status())) return step.status();
    if (!step.ok()) {
      unit.stretch.error = step.status();
      return absl::OkStatus();
    }
    for (const Bifurcation& bifurcation : step->bifurcations) AddBifurcation(bifurcation, unit);
    if (!step->points.empty()) AddPoint(unit);
  }
  CountWork(std::abs((branch.point.parameter - unit.state.from()) / (options_.to - options_.from)),
            unit);
  return absl::OkStatus();
}

absl::Status ContinuationPlan::End(Unit& unit) const {
  const BranchState& branch = unit.branch;
  const double last = branch.point.parameter;
  v1::BranchSummary& summary = *unit.found.add_branches();
  summary.set_branch(unit.state.branch());
  const int period = static_cast<int>(branch.point.cycle.points.size());
  summary.set_period(branch.points > 0 ? period : 2 * period);
  summary.set_points(branch.points);
  summary.set_from(unit.state.from());
  summary.set_to(last);
  summary.set_end(std::string(Name(branch.end)));
  if (!branch.message.empty()) summary.set_message(branch.message);
  CELT_ASSIGN_OR_RETURN(const std::unique_ptr<Map> map, family_(last));
  CELT_ASSIGN_OR_RETURN(*unit.found.mutable_accuracy(),
                        MeasureAccuracy(WithParameter(spec_, continuation_.parameter(), last), *map,
                                        SampleOf({&branch.point.cycle, 1})));
  CountWork(1, unit);
  unit.state.set_branch(unit.state.branch() + 1);
  unit.state.set_following(false);
  unit.stretch.ended = unit.state.doublings().empty();
  if (unit.stretch.ended) {
    unit.stretch.work += kPercent * (1 + continuation_.doublings() - unit.state.branch());
  }
  return absl::OkStatus();
}

absl::StatusOr<Stretch> ContinuationPlan::Advance(std::string_view state,
                                                  const jobs::StopRequested& stop) const {
  Unit unit;
  CELT_ASSIGN_OR_RETURN(unit.state, Parse<ContinuationState>(state));
  if (unit.state.following()) {
    CELT_ASSIGN_OR_RETURN(unit.branch, FromProgress(unit.state.progress()));
    CELT_RETURN_IF_ERROR(Go(unit, stop));
  } else {
    CELT_RETURN_IF_ERROR(Begin(unit));
  }
  if (unit.branch.end != BranchEnd::kNone) CELT_RETURN_IF_ERROR(End(unit));
  if (unit.state.following()) *unit.state.mutable_progress() = ToProgress(unit.branch);
  unit.stretch.state = Serialize(unit.state);
  unit.stretch.summary = Serialize(unit.found);
  return std::move(unit.stretch);
}

}  // namespace

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeContinuationPlan(const v1::JobSpec& resolved) {
  const v1::ContinuationSpec& continuation = resolved.continuation();
  const v1::JobSpec first = WithParameter(resolved, continuation.parameter(), continuation.from());
  CELT_ASSIGN_OR_RETURN(MapFamily family, MakeFamily(resolved, continuation.parameter()));
  CELT_ASSIGN_OR_RETURN(Point guess, PointFrame(first).ToPoint(continuation.near()));
  return std::make_unique<ContinuationPlan>(resolved, std::move(family), std::move(guess));
}

}  // namespace celt::plans
