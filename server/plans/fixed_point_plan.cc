#include "server/plans/fixed_point_plan.h"

#include <string>
#include <utility>

#include "server/jobs/status_macros.h"
#include "server/plans/accuracy.h"
#include "server/plans/chain_plan.h"
#include "server/plans/convert.h"
#include "server/plans/convert_cycle.h"
#include "server/plans/cycle_search_plan.h"
#include "server/plans/fixed_point_spec.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

/// The cycle near a guess: one unit.
class NewtonPlan final : public ChainPlan {
 public:
  NewtonPlan(const v1::JobSpec& resolved, std::unique_ptr<Map> map, Point guess)
      : spec_(resolved), map_(std::move(map)), guess_(std::move(guess)) {}

  jobs::Work work() const override { return {.total = 1, .unit = "cycles"}; }

 private:
  std::int64_t MostSteps() const override { return 1; }

  absl::StatusOr<Stretch> Advance(std::string_view, const jobs::StopRequested&) const override {
    const v1::FixedPointSpec& fixed_point = spec_.fixed_point();
    CELT_ASSIGN_OR_RETURN(const CycleReport cycle,
                          FindCycle(*map_, guess_, fixed_point.period(), NewtonOf(fixed_point)));
    CELT_RETURN_IF_ERROR(CheckFound(cycle, fixed_point.period()));
    Stretch stretch;
    v1::FixedPointRecord& record = *stretch.records.emplace_back().mutable_fixed_point();
    *record.mutable_cycle() = FromCycle(cycle, PointFrame(spec_));
    v1::FixedPointResult result;
    *result.add_cycles() = record.cycle();
    CELT_ASSIGN_OR_RETURN(*result.mutable_accuracy(),
                          MeasureAccuracy(spec_, *map_, SampleOf({&cycle, 1})));
    stretch.summary = Serialize(result);
    stretch.work = 1;
    stretch.ended = true;
    return stretch;
  }

  absl::StatusOr<v1::Result> MakeResult(std::string_view known) const override {
    v1::Result result;
    CELT_ASSIGN_OR_RETURN(*result.mutable_fixed_point(), Parse<v1::FixedPointResult>(known));
    return result;
  }

  const v1::JobSpec spec_;
  const std::unique_ptr<Map> map_;
  const Point guess_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeFixedPointPlan(const v1::JobSpec& resolved) {
  const v1::FixedPointSpec& fixed_point = resolved.fixed_point();
  if (fixed_point.has_search()) return CycleSearchPlan::Make(resolved);
  CELT_ASSIGN_OR_RETURN(std::unique_ptr<Map> map, MakeMap(resolved));
  CELT_ASSIGN_OR_RETURN(Point guess, PointFrame(resolved).ToPoint(fixed_point.near()));
  return std::make_unique<NewtonPlan>(resolved, std::move(map), std::move(guess));
}

}  // namespace celt::plans
