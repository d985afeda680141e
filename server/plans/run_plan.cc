#include "server/plans/run_plan.h"

#include <cstdint>
#include <vector>

#include "server/jobs/status_macros.h"

namespace celt::plans {

absl::StatusOr<std::string> RunPlan(const jobs::Plan& plan, const jobs::StopRequested& stop) {
  struct Chain {
    std::string checkpoint;
    bool ended = false;
  };
  std::vector<Chain> chains(plan.chains());
  std::string state;
  bool going = true;
  // A plan may allow for far more steps than its chains take.
  for (std::int64_t step = 0; going && step < plan.steps(); ++step) {
    going = false;
    for (std::int64_t i = 0; i < std::ssize(chains); ++i) {
      if (chains[i].ended) continue;
      if (stop()) return absl::CancelledError("stopped");
      const jobs::UnitId unit{step, i};
      CELT_ASSIGN_OR_RETURN(jobs::UnitOutput output, plan.Run(unit, chains[i].checkpoint, stop));
      CELT_ASSIGN_OR_RETURN(jobs::Collected collected, plan.Collect(unit, state, output.payload));
      state = std::move(collected.state);
      chains[i] = {.checkpoint = std::move(output.checkpoint), .ended = output.chain_ended};
      going = going || !chains[i].ended;
    }
  }
  return plan.Finish(state);
}

}  // namespace celt::plans
