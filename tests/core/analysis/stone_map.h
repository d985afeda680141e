#pragma once

#include <memory>

#include "core/map/celtic_stone_system.h"
#include "core/map/map.h"
#include "gtest/gtest.h"

namespace celt {

/// The stone's section map (body frame, g = π) with the error of its integrator a hundred times
/// below the digits that the reference values hold to.
inline std::unique_ptr<Map> StoneMap(const Parameters& parameters) {
  auto map = CelticStoneSystem().MakeMap(parameters, {.tolerance = 1e-13, .engine = Engine::kFast});
  EXPECT_TRUE(map.ok()) << map.status();
  return *std::move(map);
}

}  // namespace celt
