#pragma once

#include "Eigen/Core"
#include "core/integrate/crossing.h"
#include "core/integrate/fast/coordinates.h"
#include "core/model/celtic_stone.h"

namespace celt::bench {

using fast::FastState;
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

}  // namespace celt::bench
