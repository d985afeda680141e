#pragma once

#include "Eigen/Core"
#include "core/model/celtic_stone.h"

namespace celt {

/// The stone's motion with where it rolls to: what the reduced state (M, γ) leaves out. The plane
/// has axes X, Y fixed in space, Z up.
struct RollingState {
  StoneState stone;         ///< (M, γ)
  Eigen::Vector3d heading;  ///< unit vector of the X axis, in body axes: the attitude, with γ
  Eigen::Vector2d contact;  ///< contact point on the plane, (X, Y)
  double spin = 0;  ///< ∫ (ω, γ) dt [rad]: turned about the vertical, whole turns counted
};

/// Number of reals in a RollingState, in the order of its members.
inline constexpr int kRollingSize = 12;

/// At the origin of the plane, the X axis along the horizontal part of the body's first axis.
/// Precondition: γ₃ ≠ 0.
RollingState PlaceAtOrigin(const StoneState& stone);

/// ṙ, the velocity of the contact point over the body, in body axes. With u = γ₁/γ₃, v = γ₂/γ₃ the
/// surface is r = (−a₁u, −a₂v, −h + (a₁u² + a₂v²)/2).
///
/// The stone rolls without slipping: the body's point at the contact rests, so that in space, too,
/// the contact point moves with ṙ. It lies in the plane: (ṙ, γ) = 0.
Eigen::Vector3d ContactVelocity(const CelticStone& stone, const StoneState& state);

/// The rate of everything: the field for (M, γ), α̇ = α×ω for the heading α as for any direction
/// fixed in space, (Ẋ, Ẏ) = ((ṙ, α), (ṙ, γ×α)) and (ω, γ).
RollingState RollingRate(const CelticStone& stone, const RollingState& state);

}  // namespace celt
