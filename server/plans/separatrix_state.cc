#include "server/plans/separatrix_state.h"

#include "server/jobs/status_macros.h"
#include "server/plans/serialize.h"
#include "server/plans/state.pb.h"

namespace celt::plans {
namespace {

using Numbers = google::protobuf::RepeatedField<double>;

absl::StatusOr<Point> PointOf(const Numbers& numbers) {
  if (numbers.size() > kMaxDimension) {
    return absl::DataLossError("the stored state of a bisection is damaged");
  }
  return Point(Eigen::Map<const Eigen::VectorXd>(numbers.data(), numbers.size()));
}

SeparatrixProbeState FromProbe(const SeparatrixProbe& probe) {
  SeparatrixProbeState state;
  state.set_value(probe.value);
  state.mutable_saddle()->Add(probe.saddle.begin(), probe.saddle.end());
  state.set_iterates(probe.iterates);
  state.set_answer(probe.answer);
  state.set_end(static_cast<int>(probe.fate.end));
  state.set_side(probe.fate.side);
  state.set_changes(probe.fate.changes);
  state.set_fate_iterates(probe.fate.iterates);
  state.mutable_point()->Add(probe.fate.point.begin(), probe.fate.point.end());
  state.set_message(probe.fate.message);
  return state;
}

absl::StatusOr<SeparatrixProbe> ToProbe(const SeparatrixProbeState& state) {
  SeparatrixProbe probe;
  probe.value = state.value();
  CELT_ASSIGN_OR_RETURN(probe.saddle, PointOf(state.saddle()));
  probe.iterates = state.iterates();
  probe.answer = state.answer();
  probe.fate.end = static_cast<SeparatrixEnd>(state.end());
  probe.fate.side = state.side();
  probe.fate.changes = state.changes();
  probe.fate.iterates = state.fate_iterates();
  CELT_ASSIGN_OR_RETURN(probe.fate.point, PointOf(state.point()));
  probe.fate.message = state.message();
  return probe;
}

}  // namespace

std::string EncodeBisection(const SeparatrixBisection& bisection) {
  SeparatrixBisectionState state;
  for (const SeparatrixProbe& end : bisection.ends) *state.add_ends() = FromProbe(end);
  *state.mutable_last() = FromProbe(bisection.last);
  state.set_done(bisection.done);
  return Serialize(state);
}

absl::StatusOr<SeparatrixBisection> DecodeBisection(std::string_view bytes) {
  CELT_ASSIGN_OR_RETURN(const SeparatrixBisectionState state,
                        Parse<SeparatrixBisectionState>(bytes));
  SeparatrixBisection bisection;
  for (const SeparatrixProbeState& end : state.ends()) {
    CELT_ASSIGN_OR_RETURN(bisection.ends.emplace_back(), ToProbe(end));
  }
  CELT_ASSIGN_OR_RETURN(bisection.last, ToProbe(state.last()));
  bisection.done = state.done();
  return bisection;
}

}  // namespace celt::plans
