#include "core/model/rolling.h"

#include "Eigen/Geometry"

namespace celt {

using Eigen::Vector3d;

RollingState PlaceAtOrigin(const StoneState& stone) {
  const Vector3d gamma = stone.tail<3>();
  const Vector3d horizontal = Vector3d::UnitX() - gamma.x() * gamma;
  return {.stone = stone,
          .heading = horizontal.normalized(),
          .contact = Eigen::Vector2d::Zero(),
          .spin = 0};
}

Vector3d ContactVelocity(const CelticStone& stone, const StoneState& state) {
  const StoneParameters& p = stone.parameters();
  const Vector3d gamma = state.tail<3>();
  const Vector3d rate = gamma.cross(stone.AngularVelocity(state));
  const Vector3d slope = gamma / gamma.z();
  const Vector3d slope_rate = (rate - slope * rate.z()) / gamma.z();
  const double x = p.radius1 * slope_rate.x();
  const double y = p.radius2 * slope_rate.y();
  return {-x, -y, slope.x() * x + slope.y() * y};
}

RollingState RollingRate(const CelticStone& stone, const RollingState& state) {
  const Vector3d gamma = state.stone.tail<3>();
  const Vector3d omega = stone.AngularVelocity(state.stone);
  const Vector3d velocity = ContactVelocity(stone, state.stone);
  return {.stone = stone.Field(state.stone),
          .heading = state.heading.cross(omega),
          .contact = {velocity.dot(state.heading), velocity.dot(gamma.cross(state.heading))},
          .spin = omega.dot(gamma)};
}

}  // namespace celt
