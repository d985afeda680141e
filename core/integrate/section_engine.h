#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "core/integrate/crossing.h"
#include "core/integrate/section_event.h"
#include "core/map/system.h"
#include "core/model/celtic_stone.h"

namespace celt {

/// What Engine::kDefault stands for on a section: celt's own Runge–Kutta. Largest error of the map
/// and of its Jacobian (relative to its largest entry) over the 200 points of
/// tests/reference/section_map_752.csv:
///
///     tolerance |  fast: map   J       |  ARKODE: map   J       |  CVODE: map   J
///     1e-8      |  2.1e-7      8.0e-7  |  3.9e-9        2.6e-8  |  6.3e-7       2.0e-6
///     1e-10     |  5.3e-10     5.4e-9  |  2.8e-11       2.2e-10 |  7.7e-9       1.4e-8
///     1e-11     |  1.9e-11     1.1e-10 |  2.4e-12       2.0e-11 |  1.4e-9       1.7e-9
///     1e-12     |  1.6e-12     1.2e-11 |  2.4e-13       2.3e-12 |  2.2e-10      2.5e-10
///     1e-13     |  1.5e-13     1.3e-12 |
///
/// An Adams method starts anew at every crossing with tiny steps of order one, and what it then
/// gains is spent; it also lets errors add up to a hundred tolerances over a return, where
/// Runge–Kutta stays at a few.
inline constexpr Engine kDefaultSectionEngine = Engine::kFast;

/// The engine that `numerics` asks for, on a section.
/// INVALID_ARGUMENT when there is no such engine.
absl::StatusOr<std::unique_ptr<SectionEngine>> MakeSectionEngine(const CelticStone& stone,
                                                                 const SectionEvent& section,
                                                                 const Numerics& numerics);

}  // namespace celt
