#include "server/plans/convert_branch.h"

#include "server/plans/convert.h"
#include "server/plans/convert_cycle.h"
#include "server/plans/family.h"

namespace celt::plans {
namespace {

v1::BifurcationType FromType(BifurcationType type) {
  switch (type) {
    case BifurcationType::kPeriodDoubling:
      return v1::PERIOD_DOUBLING;
    case BifurcationType::kNeimarkSacker:
      return v1::NEIMARK_SACKER;
    case BifurcationType::kFold:
      return v1::FOLD;
    case BifurcationType::kBranchPoint:
      return v1::BRANCH_POINT;
    case BifurcationType::kMultipliersMeet:
      return v1::MULTIPLIERS_MEET;
  }
  return v1::BIFURCATION_TYPE_UNSPECIFIED;
}

void SetNormalForm(const Bifurcation& from, v1::Bifurcation& to) {
  if (from.type == BifurcationType::kNeimarkSacker) {
    to.set_angle(from.angle);
    if (!from.resonance.empty()) to.set_resonance(from.resonance);
  } else if (from.type != BifurcationType::kPeriodDoubling) {
    return;
  }
  to.set_criticality(std::string(Name(from.normal_form.criticality)));
  // Both are 0 when it could not be computed.
  if (from.normal_form.coefficient == 0 && from.normal_form.error == 0) return;
  to.set_coefficient(from.normal_form.coefficient);
  to.set_coefficient_error(from.normal_form.error);
}

}  // namespace

v1::Cycle BranchConverter::FromCycleAt(double value, const CycleReport& cycle) const {
  return FromCycle(cycle,
                   PointFrame(WithParameter(spec_, spec_.continuation().parameter(), value)));
}

v1::Record BranchConverter::PointRecord(int branch, const BranchPoint& point) const {
  v1::Record record;
  v1::BranchPoint& out = *record.mutable_continuation()->mutable_point();
  out.set_branch(branch);
  out.set_value(point.parameter);
  out.set_arclength(point.arclength);
  *out.mutable_cycle() = FromCycleAt(point.parameter, point.cycle);
  return record;
}

v1::Record BranchConverter::BifurcationRecord(int branch, const Bifurcation& bifurcation) const {
  v1::Record record;
  v1::Bifurcation& out = *record.mutable_continuation()->mutable_bifurcation();
  out.set_type(FromType(bifurcation.type));
  out.set_value(bifurcation.point.parameter);
  out.set_value_error(bifurcation.parameter_error);
  *out.mutable_cycle() = FromCycleAt(bifurcation.point.parameter, bifurcation.point.cycle);
  if (out.cycle().points_size() > 0) *out.mutable_point() = out.cycle().points(0);
  AddMultipliers(bifurcation.critical, *out.mutable_critical());
  SetNormalForm(bifurcation, out);
  out.set_branch(branch);
  return record;
}

}  // namespace celt::plans
