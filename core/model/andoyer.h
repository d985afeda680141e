#pragma once

#include "Eigen/Core"
#include "absl/status/statusor.h"
#include "core/model/celtic_stone.h"

namespace celt {

/// Andoyer–Deprit variables of a state, eq. (2.9) of Gonchenko & Gonchenko: G = |M|, L = M₃, H =
/// (M, γ), the angle l of the momentum about the body's vertical axis, tan l = M₁/M₂, and the angle
/// g of the vertical about the momentum,
///
///     G² sin g ∝ G (M₂γ₁ − M₁γ₂),   G² cos g ∝ L H − G² γ₃   (the same positive factor).
///
/// Body frame; angles in [0, 2π) [rad]; L, H, G in the units of angular momentum.
struct Andoyer {
  double L = 0;
  double H = 0;
  double G = 0;
  double l = 0;
  double g = 0;
};

/// Preconditions: M ≠ 0, |L/G| < 1 and |H/G| < 1; elsewhere an angle is undefined and the value
/// given means nothing.
Andoyer ToAndoyer(const StoneState& state);

/// The state with |γ| = 1. Preconditions: G > 0, |L/G| ≤ 1, |H/G| ≤ 1.
StoneState FromAndoyer(const Andoyer& andoyer);

/// Coordinates (l, L/G, H/G) of a point of the section g = g₀ in the level H = E of energy; body
/// frame, l in [0, 2π) [rad].
using SectionPoint = Eigen::Vector3d;

/// A point of the section as a state.
struct LiftedPoint {
  StoneState state;
  Eigen::Matrix<double, 6, 3> derivative;  ///< ∂(M, γ)/∂(l, L/G, H/G) along the section, exact
};

/// Lifts a point of the section to the state: γ by eq. (2.9), then |M| = G from the energy,
/// G² = 2(E + m g (r, γ))/(m̂, A⁻¹m̂) with m̂ = M/G.
///
/// INVALID_ARGUMENT names the field, its value and the allowed range: `l`, `l_over_g` or `h_over_g`
/// is not finite or not in (−1, 1); `energy` is not above the potential energy −m g (r, γ) there,
/// so that the level is empty; |γ₃| < kLeastGamma3 there.
absl::StatusOr<LiftedPoint> LiftToLevel(const CelticStone& stone, double energy,
                                        double section_angle, const SectionPoint& x);

/// A state in the coordinates of the section, whatever its g and its energy.
struct ProjectedState {
  SectionPoint x;
  Eigen::Matrix<double, 3, 6> derivative;  ///< ∂(l, L/G, H/G)/∂(M, γ), exact
};

/// Precondition: M ≠ 0 and |L/G| < 1; elsewhere l is undefined, and the derivative is not finite.
ProjectedState ProjectToSection(const StoneState& state);

/// From the body frame to the paper's and back: the same formula both ways. In the paper's frame
/// the axes are those of inertia, the stone is the mirror image (δ → −δ) and γ points down; then l'
/// = −(l + δ), (L/G)' = −L/G, (H/G)' = H/G, and the section g = g₀ is g' = g₀ − π. The two section
/// maps are conjugate: multipliers and exponents are the same. `delta` is that of the body frame
/// [rad].
SectionPoint ExchangeFrame(const SectionPoint& x, double delta);

}  // namespace celt
