#pragma once

#include <array>

#include "core/integrate/fast/stone_constants.h"

namespace celt::bench {

/// A crossing to be computed by Boost.odeint, as plain numbers.
struct OdeintProblem {
  fast::StoneConstants constants;
  double gravity = 0;  ///< with the sign of γ₃
  double cosine = -1;  ///< of the section's angle
  double sine = 0;
  double tolerance = 0;
};

/// (ω, q), then with tangents three of these.
template <int kTangents>
using OdeintState = std::array<double, 5 * (1 + kTangents)>;

/// Carries a state forward in time to the section: Runge–Kutta–Fehlberg 7(8) with step control over
/// all components, and from the last step before the section repeated steps of the length that
/// Newton's method finds. `rate` is the field there. False: no crossing in 20,000 steps.
template <int kTangents>
bool CrossByOdeint(const OdeintProblem& problem, OdeintState<kTangents>& state,
                   OdeintState<kTangents>& rate, double& time);

}  // namespace celt::bench
