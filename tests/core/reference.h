#pragma once

#include <vector>

#include "core/map/map.h"
#include "core/model/celtic_stone.h"

namespace celt {

/// One application of the section map at E = 752, g = π, default parameters, in quadruple
/// precision: a row of tests/reference/section_map_752.csv.
struct ReferenceIterate {
  StoneState state;
  Eigen::Vector3d point;
  double time = 0;
  Eigen::Vector3d image;
  Eigen::Matrix3d jacobian;
};

/// A fixed point of the section map at g = π, from tests/reference/celtic_stone.json.
struct ReferenceFixedPoint {
  double energy = 0;
  double delta = 0;
  Eigen::Vector3d point;
  double time = 0;
  Eigen::Vector3d multipliers;  ///< real, in increasing order
};

std::vector<ReferenceIterate> ReferenceIterates();
std::vector<ReferenceFixedPoint> ReferenceFixedPoints();

}  // namespace celt
