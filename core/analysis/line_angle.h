#pragma once

#include <algorithm>
#include <cmath>

#include "core/map/map.h"

namespace celt {

/// The angle in [0, π/2] between the lines along two unit vectors [rad], accurate down to rounding,
/// which arccos |⟨a, b⟩| is not for small angles.
inline double AngleOfLines(const Point& a, const Point& b) {
  const double chord = std::min((a - b).norm(), (a + b).norm());
  return 2 * std::asin(std::min(1.0, chord / 2));
}

}  // namespace celt
