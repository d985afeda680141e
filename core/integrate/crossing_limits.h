#pragma once

namespace celt {

/// When an orbit that does not come back is given up.
struct CrossingLimits {
  /// In units of 2π √(a/g), a the larger radius of curvature: about the slowest oscillation of the
  /// stone.
  double longest_time = 200;
  int most_steps = 20'000;
};

}  // namespace celt
