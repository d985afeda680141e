#pragma once

#include "core/map/system.h"
#include "core/model/celtic_stone.h"

namespace celt {

/// The section map of the Celtic stone (core/map/section_map.h); coordinates l [rad], L/G, H/G in
/// the body frame. The default start lies by the saddle fixed point O* of the default parameters,
/// in the basin of the discrete attractor around it.
const System& CelticStoneSystem();

/// The stone of this system's parameters, of which all must be there.
StoneParameters StoneParametersOf(const Parameters& parameters);

}  // namespace celt
