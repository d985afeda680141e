#include "server/plans/convert_cycle.h"

#include "core/analysis/cycle_type.h"

namespace celt::plans {

void AddMultipliers(std::span<const Multiplier> multipliers,
                    google::protobuf::RepeatedPtrField<v1::Multiplier>& out) {
  for (const Multiplier& multiplier : multipliers) {
    v1::Multiplier& added = *out.Add();
    added.set_re(multiplier.real());
    added.set_im(multiplier.imag());
  }
}

v1::Cycle FromCycle(const CycleReport& cycle, const PointFrame& frame) {
  v1::Cycle out;
  for (const Point& point : cycle.points) *out.add_points() = frame.FromPoint(point);
  out.set_period(static_cast<int>(cycle.points.size()));
  out.set_return_time(cycle.return_time);
  AddMultipliers(cycle.multipliers, *out.mutable_multipliers());
  out.set_residual(cycle.residual);
  out.set_correction(cycle.correction);
  const CycleType type = TypeOf(cycle.multipliers);
  out.set_type(type.name);
  out.mutable_sides()->Add(type.sides.begin(), type.sides.end());
  for (const CycleCondition& condition : LorenzConditions(cycle.multipliers)) {
    v1::Inequality& inequality = *out.add_lorenz_conditions();
    inequality.set_name(condition.name);
    inequality.set_holds(condition.holds);
    inequality.set_margin(condition.margin);
  }
  return out;
}

}  // namespace celt::plans
