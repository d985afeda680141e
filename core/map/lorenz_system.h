#pragma once

#include "core/map/system.h"

namespace celt {

/// The Lorenz flow (Lorenz 1963), sampled every `step` units of time; coordinates x, y, z:
///
///     ẋ = σ(y − x),   ẏ = x(ρ − z) − y,   ż = xy − βz,      div = −(σ + 1 + β).
const System& LorenzSystem();

}  // namespace celt
