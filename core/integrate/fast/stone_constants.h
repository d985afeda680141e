#pragma once

#include "core/model/celtic_stone.h"

namespace celt::fast {

/// What the fast equations of motion know of a stone, in the units of its parameters. Mass drops
/// out of them: dividing M = Aω and Ṁ by m leaves I/m as the only trace of it.
struct StoneConstants {
  explicit StoneConstants(const CelticStone& stone);

  double j11, j12, j22, j33;  ///< I/m in body axes; j13 = j23 = 0
  double a1, a2;              ///< principal radii of curvature
  double a21;                 ///< a₂ − a₁
  double height;
  double gravity;
  /// β and c of the pace of scaled time, dt/dτ = (|ω|² + β|q̇|² + c tr A/det A)^(−1/2)
  /// (stone_rate-inl.h).
  double pace_roll;
  double pace_rest;
  double least_spin;  ///< g over the radius of gyration: the least |ω|² that an error of ω is
                      ///< compared with
};

}  // namespace celt::fast
