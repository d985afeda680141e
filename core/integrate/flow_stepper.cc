#include "core/integrate/flow_stepper.h"

namespace celt {

absl::StatusOr<std::unique_ptr<OdeStepper>> MakeFlowStepper(Engine engine,
                                                            const OdeProblem& problem,
                                                            std::span<const double> start) {
  switch (engine) {
    case Engine::kCvode:
      return MakeAdamsStepper(problem, start);
    case Engine::kDefault:
    case Engine::kArkode:
      return MakeRungeKuttaStepper(problem, start);
    case Engine::kFast:
      break;
  }
  return absl::InvalidArgumentError(
      "engine: the fast engine goes from section to section only; use default, cvode or arkode");
}

}  // namespace celt
