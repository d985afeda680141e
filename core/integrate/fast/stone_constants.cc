#include "core/integrate/fast/stone_constants.h"

#include <cmath>

#include "Eigen/LU"

namespace celt::fast {

StoneConstants::StoneConstants(const CelticStone& stone) {
  const StoneParameters& p = stone.parameters();
  const Eigen::Matrix3d inertia = stone.inertia() / p.mass;
  j11 = inertia(0, 0);
  j12 = inertia(0, 1);
  j22 = inertia(1, 1);
  j33 = inertia(2, 2);
  a1 = p.radius1;
  a2 = p.radius2;
  a21 = p.radius2 - p.radius1;
  height = p.height;
  gravity = p.gravity;

  // Chosen by counting steps on the attractor of the default stone. Only how even the steps are
  // depends on them. The rest term is a frequency squared, g over the radius of gyration.
  constexpr double kRoll = 0.21;
  constexpr double kRest = 9.45;
  const double determinant = (j11 * j22 - j12 * j12) * j33;
  const double gyration = std::sqrt(std::cbrt(determinant));
  least_spin = gravity / gyration;
  pace_roll = kRoll;
  pace_rest = kRest * gravity * std::sqrt(determinant);
}

}  // namespace celt::fast
