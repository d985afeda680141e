#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/map/map.h"

namespace celt::bench {

/// An integrator to measure: a name and a tolerance.
struct Tool {
  /// "fast", "arkode", "cvode"; "odeint" with the equations as they stand in the literature,
  /// "odeint-fast" with those of the fast engine.
  std::string name;
  double tolerance = 0;
};

/// Every tool at the tolerances around the accuracy that is compared.
const std::vector<Tool>& Tools();

/// The section map of the default stone at E = 752, g = π, by a tool.
std::unique_ptr<Map> MakeMap(const Tool& tool);

/// Points of the attractor.
std::vector<Point> Starts(int count);

/// Largest errors over the quadruple-precision reference.
struct Errors {
  double alone = 0;     ///< of the map, asked for without its Jacobian
  double map = 0;       ///< of the map, asked for with it
  double jacobian = 0;  ///< relative to the largest entry
};
Errors ErrorsOf(const Map& map);

}  // namespace celt::bench
