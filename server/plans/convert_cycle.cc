#include "server/plans/convert_cycle.h"

#include <string>

#include "absl/strings/str_cat.h"
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

namespace {

std::string Effort(const CycleReport& cycle) {
  return absl::StrCat("; residual ", cycle.residual, " after ", cycle.iterations,
                      cycle.iterations == 1 ? " iteration" : " iterations");
}

}  // namespace

absl::Status CheckFound(const CycleReport& cycle, int period) {
  const std::string wanted = absl::StrCat("no cycle of period ", period, " found: ");
  if (cycle.converged() && cycle.minimal_period == period) return absl::OkStatus();
  if (cycle.converged()) {
    return absl::NotFoundError(absl::StrCat(wanted, "Newton's method came to one of period ",
                                            cycle.minimal_period, ", gone round ",
                                            period / cycle.minimal_period,
                                            " times; another guess "
                                            "or a search may find one",
                                            Effort(cycle)));
  }
  const std::string name(Name(cycle.termination));
  const bool named = cycle.message.rfind(name, 0) == 0;
  const bool lost = cycle.termination == CycleTermination::kLeftDomain;
  return absl::Status(lost ? absl::StatusCode::kOutOfRange : absl::StatusCode::kNotFound,
                      absl::StrCat(wanted, named ? "" : name + ": ", cycle.message, Effort(cycle)));
}

v1::SeparatrixFate FromFate(const SeparatrixFate& fate, int iterates, const PointFrame& frame) {
  v1::SeparatrixFate out;
  out.set_end(Name(fate.end));
  out.set_side(fate.side);
  out.set_changes(fate.changes);
  out.set_iterates(fate.iterates * iterates);
  *out.mutable_point() = frame.FromPoint(fate.point);
  if (!fate.message.empty()) out.set_message(fate.message);
  return out;
}

std::vector<Point> SampleOf(std::span<const CycleReport> cycles) {
  constexpr std::size_t kEnough = 24;
  std::vector<Point> sample;
  for (const CycleReport& cycle : cycles) {
    for (const Point& point : cycle.points) {
      if (sample.size() == kEnough) return sample;
      sample.push_back(point);
    }
  }
  return sample;
}

}  // namespace celt::plans
