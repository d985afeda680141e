#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/analysis/shooting.h"

namespace celt {

/// What a cycle looks like nearby, by where its multipliers lie.
enum class CycleKind {
  kNode,           ///< all inside, or all outside the unit circle, and real
  kFocus,          ///< all inside, or all outside, with a complex pair
  kSaddle,         ///< some on either side, all real
  kSaddleFocus,    ///< some on either side, with a complex pair
  kNonHyperbolic,  ///< some on the circle
};

struct CycleType {
  CycleKind kind = CycleKind::kNonHyperbolic;
  int stable = 0;    ///< multipliers inside the unit circle: dimension of the stable manifold
  int unstable = 0;  ///< outside: dimension of the unstable manifold
  int neutral = 0;   ///< on it, within the tolerance asked for
  /// For each multiplier, in the order given: +1 or −1, the sign of a real one (−1: orbits change
  /// sides with each turn); 0 for one of a complex pair.
  std::vector<int> sides;
  /// "stable node", "unstable focus", "saddle 2-1", "saddle-focus 1-2", "non-hyperbolic 2-0"; the
  /// two numbers are `stable` and `unstable`, as in Shilnikov, Shilnikov, Turaev & Chua (1998).
  std::string name;
};

/// Classifies a cycle by its multipliers; one within `tolerance` of the unit circle, in modulus,
/// is neutral.
CycleType TypeOf(std::span<const Multiplier> multipliers, double tolerance = 1e-8);

/// An inequality lhs > 0 with its left side.
struct CycleCondition {
  const char* name;
  bool holds = false;
  double margin = 0;  ///< the left side: positive where it holds
};

/// The test of a fixed point that may carry a discrete Lorenz attractor, of Gonchenko & Gonchenko
/// (2016), §4, item 1: real multipliers γ, λ1, λ2 with |λ2| < |λ1| < 1 < |γ|, λ1 > 0, λ2 < 0,
/// γ < −1 and |λ1 γ| > 1. Each inequality with its margin; "real multipliers" has minus the largest
/// imaginary part for its margin, and with a complex pair the signs are those of real parts. Empty
/// unless there are three multipliers, which are to be given by decreasing modulus.
std::vector<CycleCondition> LorenzConditions(std::span<const Multiplier> multipliers);

}  // namespace celt
