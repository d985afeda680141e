#include "core/integrate/fast/coordinates.h"

#include <cmath>

namespace celt::fast {

StoneState ToMomentum(const CelticStone& stone, const FastState& x, double up) {
  const Eigen::Vector3d upward(x[3], x[4], 1);
  const Eigen::Vector3d gamma = up / upward.norm() * upward;
  StoneState state;
  state << stone.ContactInertia(gamma) * x.head<3>(), gamma;
  return state;
}

}  // namespace celt::fast
