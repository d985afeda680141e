#include "server/plans/branch_state.h"

#include "server/jobs/status_macros.h"
#include "server/plans/cycle_state.h"

namespace celt::plans {

BranchProgress ToProgress(const BranchState& branch) {
  BranchProgress progress;
  *progress.mutable_cycle() = ToState(branch.point.cycle);
  progress.set_parameter(branch.point.parameter);
  progress.set_arclength(branch.point.arclength);
  progress.mutable_tangent()->Add(branch.point.tangent.begin(), branch.point.tangent.end());
  progress.set_orientation(branch.point.orientation);
  progress.set_step(branch.step);
  progress.set_points(branch.points);
  progress.set_end(static_cast<int>(branch.end));
  progress.set_message(branch.message);
  return progress;
}

absl::StatusOr<BranchState> FromProgress(const BranchProgress& progress) {
  BranchState branch;
  CELT_ASSIGN_OR_RETURN(branch.point.cycle, FromState(progress.cycle()));
  if (progress.tangent_size() != progress.cycle().points_size() + 1) {
    return absl::DataLossError("the stored state of a branch is damaged");
  }
  branch.point.parameter = progress.parameter();
  branch.point.arclength = progress.arclength();
  branch.point.tangent =
      Eigen::Map<const Eigen::VectorXd>(progress.tangent().data(), progress.tangent_size());
  branch.point.orientation = progress.orientation();
  branch.step = progress.step();
  branch.points = progress.points();
  branch.end = static_cast<BranchEnd>(progress.end());
  branch.message = progress.message();
  return branch;
}

}  // namespace celt::plans
