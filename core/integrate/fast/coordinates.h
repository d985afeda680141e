#pragma once

#include "Eigen/Core"
#include "core/model/celtic_stone.h"

namespace celt::fast {

/// (ω₁, ω₂, ω₃, q₁, q₂), q = (γ₁, γ₂)/γ₃: the coordinates that the fast engine works in. With the
/// sign of γ₃ they are one to one with the states of |γ| = 1, γ₃ ≠ 0.
using FastState = Eigen::Matrix<double, 5, 1>;

/// The state (M, γ); `up` is the sign of γ₃. Derivatives, the way back and many orbits at once:
/// momentum_chart-inl.h.
StoneState ToMomentum(const CelticStone& stone, const FastState& x, double up);

}  // namespace celt::fast
