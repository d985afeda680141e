#pragma once

#include "core/analysis/lyapunov.h"

namespace celt {

/// What an attractor of a three-dimensional map is, by the signs of its exponents. For the section
/// of a flow: the flow's own zero exponent is not among them, so that a cycle of the flow has three
/// negative ones, and a torus a zero and two negative ones.
enum class Regime {
  kUnknown,         ///< the errors are too large to tell, or the map is not three-dimensional
  kPeriodic,        ///< all negative
  kInvariantCurve,  ///< the largest zero, the others negative
  kChaos,           ///< the largest positive
  /// Chaos that fulfils all of LyapunovReport::conditions, whose estimates decide: Λ₂ of a
  /// Lorenz-like attractor is zero as far as anyone can measure.
  kPseudoHyperbolicCandidate
};

/// An exponent has a sign when it is more than three standard errors from zero. It is zero when it
/// is not, and three errors are less than a hundredth of the next exponent: so small that no chaos
/// worth the name would hide in them. What is neither is unknown, as is everything from
/// fewer than kFewestBatches.
Regime RegimeOf(const LyapunovReport& report);

}  // namespace celt
