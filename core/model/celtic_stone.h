#pragma once

#include "Eigen/Core"
#include "absl/status/status.h"

namespace celt {

/// A rigid body with the surface of an elliptic paraboloid that rolls without slipping on a plane
/// (Gonchenko & Gonchenko, Lorenz-like attractors in nonholonomic models of Celtic stone, §2).
/// Defaults are the paper's. Any coherent set of units will do; the paper's are dimensionless.
struct StoneParameters {
  double inertia1 = 2;  ///< principal moments of inertia about the centre of mass, I₁, I₂, I₃ > 0;
  double inertia2 = 6;  ///<   of a body, so each is at most the sum of the others
  double inertia3 = 7;
  double mass = 1;       ///< m > 0
  double gravity = 100;  ///< g > 0
  double radius1 = 9;  ///< principal radii of curvature at the vertex of the paraboloid, a₁, a₂ > 0
  double radius2 = 4;
  double height = 1;     ///< of the centre of mass above the vertex, h > 0
  double delta = 0.485;  ///< angle from the geometric to the inertial horizontal axes [rad]
};

/// INVALID_ARGUMENT names the parameter, its value and the allowed range.
absl::Status CheckStone(const StoneParameters& parameters);

/// State (M, γ): angular momentum about the contact point, unit upward vertical; both in body axes.
using StoneState = Eigen::Matrix<double, 6, 1>;
using StoneMatrix = Eigen::Matrix<double, 6, 6>;

/// An orbit with |γ₃| below this is lost: the contact point is some 2·10⁴ radii of curvature away,
/// and orbits that get there have been seen to run off for good.
inline constexpr double kLeastGamma3 = 5e-3;

/// The equations of motion
///
///     Ṁ = M×ω + m ṙ×(ω×r) + m g r×γ,   γ̇ = γ×ω,   M = Iω + m r×(ω×r),
///     r = (−a₁γ₁/γ₃, −a₂γ₂/γ₃, −h + (a₁γ₁² + a₂γ₂²)/(2γ₃²)),
///
/// singular at γ₃ = 0, where the contact point runs off to infinity: callers keep away from there.
/// Immutable.
class CelticStone {
 public:
  /// Precondition: CheckStone(parameters) is OK.
  explicit CelticStone(const StoneParameters& parameters);

  const StoneParameters& parameters() const { return parameters_; }
  /// I in body axes, eq. (2.6) of the paper.
  const Eigen::Matrix3d& inertia() const { return inertia_; }

  /// r(γ), from the centre of mass to the contact point.
  Eigen::Vector3d ContactPoint(const Eigen::Vector3d& gamma) const;
  /// The matrix A(γ) = I + m(|r|² − r rᵀ) of M = A ω: inertia about the contact point.
  Eigen::Matrix3d ContactInertia(const Eigen::Vector3d& gamma) const;
  /// ω = A⁻¹ M.
  Eigen::Vector3d AngularVelocity(const StoneState& state) const;

  /// (Ṁ, γ̇).
  StoneState Field(const StoneState& state) const;
  /// ∂(Ṁ, γ̇)/∂(M, γ), exact.
  StoneMatrix FieldJacobian(const StoneState& state) const;

  /// H = ½(M, ω) − m g (r, γ): conserved.
  double Energy(const StoneState& state) const;
  /// ∂H/∂(M, γ), exact.
  StoneState EnergyGradient(const StoneState& state) const;
  /// −m g (r, γ): potential energy, the least that H can be at this γ.
  double Potential(const Eigen::Vector3d& gamma) const;

 private:
  StoneParameters parameters_;
  Eigen::Matrix3d inertia_;
};

}  // namespace celt
