#pragma once

#include <cmath>
#include <numbers>

namespace celt {

/// The angle in [0, 2π) that differs from `angle` [rad] by whole turns.
inline double WrapToTurn(double angle) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double wrapped = std::fmod(angle, kTurn);
  const double positive = wrapped < 0 ? wrapped + kTurn : wrapped;
  return positive < kTurn ? positive : 0;  // a tiny negative angle rounds up to a whole turn
}

/// The angle in (−π, π] that differs from `angle` [rad] by whole turns.
inline double WrapToHalfTurns(double angle) {
  const double wrapped = std::remainder(angle, 2 * std::numbers::pi);
  return wrapped > -std::numbers::pi ? wrapped : std::numbers::pi;
}

}  // namespace celt
