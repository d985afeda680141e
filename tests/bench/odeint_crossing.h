#pragma once

#include <array>

#include "core/integrate/fast/stone_constants.h"
#include "core/model/celtic_stone.h"

namespace celt::bench {

/// The stone's equations as they stand in the literature, in (M, γ), with the section
/// g = g₀ (celtic_stone.h, section_event.h). Plain numbers throughout, so that the file that has
/// the best flags shares no inline function with others.
struct MomentumEquations {
  static constexpr int kComponents = 6;
  StoneParameters stone;
  double inertia11, inertia12, inertia22;  ///< in body axes
  double cosine, sine;                     ///< of g₀
};

/// The equations that the fast engine has, in (ω, q), tangents by hand (stone_rate-inl.h); one lane
/// wide.
struct FastEquations {
  static constexpr int kComponents = 5;
  fast::StoneConstants constants;
  double gravity;       ///< with the sign of γ₃
  double cosine, sine;  ///< of g₀
};

/// A state, then with tangents three of them.
template <class Equations, int kTangents>
using OdeintState = std::array<double, Equations::kComponents*(1 + kTangents)>;

/// Carries a state forward in time to the section by Boost.odeint: Runge–Kutta–Fehlberg 7(8) with
/// step control over all components, and from the last step before the section repeated steps of
/// the length that Newton's method finds. `rate` is the field there. False: no crossing in 20,000
/// steps.
template <class Equations, int kTangents>
bool CrossByOdeint(const Equations& equations, double tolerance,
                   OdeintState<Equations, kTangents>& state,
                   OdeintState<Equations, kTangents>& rate, double& time);

}  // namespace celt::bench
