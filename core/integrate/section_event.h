#pragma once

#include "core/model/celtic_stone.h"

namespace celt {

/// Which crossings of a section count.
enum class Crossings { kIncreasing, kDecreasing };

/// The section g = g₀ of Andoyer–Deprit variables as a smooth function of the state that vanishes
/// on it:
///
///     e = S cos g₀ − C sin g₀ = κ sin(g − g₀),   S = M₂γ₁ − M₁γ₂,   C = (L H − G² γ₃)/G,
///
/// with κ = G √(1 − (L/G)²) √(1 − (H/G)²) > 0. A crossing with g increasing is one where e grows
/// through zero on the side S sin g₀ + C cos g₀ = κ cos(g − g₀) > 0; on the other side lies g₀ + π.
/// For crossings with g decreasing e has the other sign: what counts always grows through zero.
/// Immutable.
class SectionEvent {
 public:
  /// `angle` is g₀ [rad], in the body frame. An angle alone stands for its section, crossed with g
  /// increasing.
  // NOLINTNEXTLINE(google-explicit-constructor)
  SectionEvent(double angle, Crossings crossings = Crossings::kIncreasing);

  double cosine() const { return cos_; }  ///< of g₀
  double sine() const { return sin_; }    ///< of g₀
  /// 1 for crossings with g increasing, −1 with g decreasing.
  double sense() const { return sense_; }

  double Value(const StoneState& state) const;
  double Side(const StoneState& state) const;
  /// ∂e/∂(M, γ), exact.
  StoneState Gradient(const StoneState& state) const;

 private:
  double cos_;
  double sin_;
  double sense_;
};

}  // namespace celt
