#pragma once

#include <memory>
#include <span>

#include "absl/status/statusor.h"
#include "core/integrate/ode_stepper.h"
#include "core/map/system.h"

namespace celt {

/// A stepper for a flow on its own, not from section to section; kDefault is kArkode.
/// INVALID_ARGUMENT: the engine is kFast, which knows the way from section to section only.
absl::StatusOr<std::unique_ptr<OdeStepper>> MakeFlowStepper(Engine engine,
                                                            const OdeProblem& problem,
                                                            std::span<const double> start);

}  // namespace celt
