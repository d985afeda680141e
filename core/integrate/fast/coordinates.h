#pragma once

#include "Eigen/Core"
#include "core/integrate/crossing.h"
#include "core/model/celtic_stone.h"

namespace celt::fast {

/// (ω₁, ω₂, ω₃, q₁, q₂), q = (γ₁, γ₂)/γ₃: the coordinates that the fast engine works in. With the
/// sign of γ₃ they are one to one with the states of |γ| = 1, γ₃ ≠ 0.
using FastState = Eigen::Matrix<double, 5, 1>;
/// Tangent vectors in these coordinates, one a column.
using FastTangents = Eigen::Matrix<double, 5, 3>;

/// A state, and how (M, γ) changes with (ω, q) there.
struct Chart {
  StoneState state;
  Eigen::Matrix<double, 6, 5> derivative;
};

/// `up` is the sign of γ₃.
Chart ToMomentum(const CelticStone& stone, const FastState& x, double up);

/// Precondition: γ₃ ≠ 0. |γ| is taken as 1.
FastState FromMomentum(const CelticStone& stone, const StoneState& state);

/// Precondition: `tangents` are tangent to |γ| = 1; what they have along γ is dropped.
FastTangents FromMomentum(const CelticStone& stone, const FastState& x, double up,
                          const StoneTangents& tangents);

}  // namespace celt::fast
