#pragma once

#include <cstdint>

namespace celt {

/// Counts how often a stone reverses its spin, from the turns about the vertical along its orbit:
/// plain data, all that is needed to go on.
///
/// The spin of a stone that wobbles crosses zero in every wobble, and counting zeros would count
/// those. A reversal is a turning back by at least kLeastTurns from the farthest that it had come,
/// after at least as much the other way.
struct Reversals {
  static constexpr double kLeastTurns = 0.25;

  int sense = 0;  ///< of the spin now: 1, -1, or 0 before it has one
  /// Turns at the ends of what was turned since the last reversal; the same sign as `turns`.
  double lowest = 0;
  double highest = 0;
  std::int64_t count = 0;

  /// Takes the next value of the turns since the start.
  void Take(double turns);
};

}  // namespace celt
