#include "core/model/celtic_stone.h"

#include <cmath>

#include "Eigen/Geometry"
#include "Eigen/LU"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"

namespace celt {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

absl::Status CheckPositive(absl::string_view name, double value) {
  if (std::isfinite(value) && value > 0) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(name, ": ", value, " is not allowed; must be positive"));
}

/// `moment` of a body is at most the sum of the other two: each is a sum of two of ∫x², ∫y², ∫z².
absl::Status CheckTriangle(absl::string_view name, double moment, double other, double another) {
  if (moment <= other + another) return absl::OkStatus();
  return absl::InvalidArgumentError(absl::StrCat(
      name, ": ", moment, " is not allowed; of a body it is at most the sum of the other two, ",
      other + another));
}

/// Eq. (2.6) of the paper: the principal axes are turned by δ from the geometric ones.
Matrix3d InertiaTensor(const StoneParameters& p) {
  const double c = std::cos(p.delta);
  const double s = std::sin(p.delta);
  const double mixed = (p.inertia1 - p.inertia2) * c * s;
  Matrix3d inertia;
  inertia << p.inertia1 * c * c + p.inertia2 * s * s, mixed, 0,  //
      mixed, p.inertia1 * s * s + p.inertia2 * c * c, 0,         //
      0, 0, p.inertia3;
  return inertia;
}

/// [a]×, with [a]× b = a×b.
Matrix3d Cross(const Vector3d& a) {
  Matrix3d m;
  m << 0, -a.z(), a.y(),  //
      a.z(), 0, -a.x(),   //
      -a.y(), a.x(), 0;
  return m;
}

/// a1γ1² + a2γ2².
double Bulge(const StoneParameters& p, const Vector3d& gamma) {
  return p.radius1 * gamma.x() * gamma.x() + p.radius2 * gamma.y() * gamma.y();
}

/// ∂r/∂γ.
Matrix3d ContactJacobian(const StoneParameters& p, const Vector3d& gamma) {
  const double inverse = 1 / gamma.z();
  const double x = p.radius1 * gamma.x() * inverse * inverse;
  const double y = p.radius2 * gamma.y() * inverse * inverse;
  const double z = Bulge(p, gamma) * inverse * inverse * inverse;
  Matrix3d jacobian;
  jacobian << -p.radius1 * inverse, 0, x,  //
      0, -p.radius2 * inverse, y,          //
      x, y, -z;
  return jacobian;
}

/// ∂((∂r/∂γ) v)/∂γ at constant v.
Matrix3d ContactCurvature(const StoneParameters& p, const Vector3d& gamma, const Vector3d& v) {
  const double inverse = 1 / gamma.z();
  const double a1 = p.radius1 * inverse * inverse;
  const double a2 = p.radius2 * inverse * inverse;
  const double b1 = -2 * a1 * gamma.x() * inverse;
  const double b2 = -2 * a2 * gamma.y() * inverse;
  const double c = 3 * Bulge(p, gamma) * inverse * inverse * inverse * inverse;
  Matrix3d curvature;
  curvature << a1 * v.z(), 0, a1 * v.x() + b1 * v.z(),   //
      0, a2 * v.z(), a2 * v.y() + b2 * v.z(),            //
      a1 * v.x() + b1 * v.z(), a2 * v.y() + b2 * v.z(),  //
      b1 * v.x() + b2 * v.y() + c * v.z();
  return curvature;
}

/// ∂((∂A) ω)/∂r at constant ω: what a shift of the contact point does to the momentum of a
/// rotation.
Matrix3d MomentumByContact(double mass, const Vector3d& r, const Vector3d& omega) {
  return mass *
         (2 * omega * r.transpose() - r.dot(omega) * Matrix3d::Identity() - r * omega.transpose());
}

}  // namespace

absl::Status CheckStone(const StoneParameters& p) {
  absl::Status status;
  status.Update(CheckPositive("inertia_1", p.inertia1));
  status.Update(CheckPositive("inertia_2", p.inertia2));
  status.Update(CheckPositive("inertia_3", p.inertia3));
  status.Update(CheckPositive("mass", p.mass));
  status.Update(CheckPositive("gravity", p.gravity));
  status.Update(CheckPositive("radius_1", p.radius1));
  status.Update(CheckPositive("radius_2", p.radius2));
  status.Update(CheckPositive("height", p.height));
  if (!std::isfinite(p.delta)) {
    status.Update(absl::InvalidArgumentError(
        absl::StrCat("delta: ", p.delta, " is not allowed; must be finite")));
  }
  status.Update(CheckTriangle("inertia_1", p.inertia1, p.inertia2, p.inertia3));
  status.Update(CheckTriangle("inertia_2", p.inertia2, p.inertia3, p.inertia1));
  status.Update(CheckTriangle("inertia_3", p.inertia3, p.inertia1, p.inertia2));
  return status;
}

CelticStone::CelticStone(const StoneParameters& parameters)
    : parameters_(parameters), inertia_(InertiaTensor(parameters)) {}

Vector3d CelticStone::ContactPoint(const Vector3d& gamma) const {
  const double inverse = 1 / gamma.z();
  return {-parameters_.radius1 * gamma.x() * inverse, -parameters_.radius2 * gamma.y() * inverse,
          -parameters_.height + 0.5 * Bulge(parameters_, gamma) * inverse * inverse};
}

Matrix3d CelticStone::ContactInertia(const Vector3d& gamma) const {
  const Vector3d r = ContactPoint(gamma);
  return inertia_ + parameters_.mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
}

Vector3d CelticStone::AngularVelocity(const StoneState& state) const {
  return ContactInertia(state.tail<3>()).inverse() * state.head<3>();
}

StoneState CelticStone::Field(const StoneState& state) const {
  const Vector3d momentum = state.head<3>();
  const Vector3d gamma = state.tail<3>();
  const Vector3d r = ContactPoint(gamma);
  const Vector3d omega = AngularVelocity(state);
  const Vector3d gamma_rate = gamma.cross(omega);
  const Vector3d r_rate = ContactJacobian(parameters_, gamma) * gamma_rate;
  StoneState rate;
  rate << momentum.cross(omega) + parameters_.mass * r_rate.cross(omega.cross(r)) +
              parameters_.mass * parameters_.gravity * r.cross(gamma),
      gamma_rate;
  return rate;
}

StoneMatrix CelticStone::FieldJacobian(const StoneState& state) const {
  const double mass = parameters_.mass;
  const Vector3d momentum = state.head<3>();
  const Vector3d gamma = state.tail<3>();
  const Vector3d r = ContactPoint(gamma);
  const Matrix3d r_by_gamma = ContactJacobian(parameters_, gamma);
  // M = Aω gives ∂ω/∂M = A⁻¹ and ∂ω/∂γ = −A⁻¹ (∂A/∂γ) ω.
  const Matrix3d omega_by_momentum = ContactInertia(gamma).inverse();
  const Vector3d omega = omega_by_momentum * momentum;
  const Matrix3d omega_by_gamma =
      -omega_by_momentum * MomentumByContact(mass, r, omega) * r_by_gamma;

  const Vector3d gamma_rate = gamma.cross(omega);
  const Matrix3d gamma_rate_by_momentum = Cross(gamma) * omega_by_momentum;
  const Matrix3d gamma_rate_by_gamma = Cross(gamma) * omega_by_gamma - Cross(omega);

  // ṙ = (∂r/∂γ) γ̇ and the velocity u = ω×r of the contact point relative to the centre of mass.
  const Vector3d r_rate = r_by_gamma * gamma_rate;
  const Vector3d u = omega.cross(r);
  const Matrix3d r_rate_by_gamma =
      r_by_gamma * gamma_rate_by_gamma + ContactCurvature(parameters_, gamma, gamma_rate);
  const Matrix3d u_by_gamma = Cross(omega) * r_by_gamma - Cross(r) * omega_by_gamma;

  StoneMatrix jacobian;
  jacobian.topLeftCorner<3, 3>() = Cross(momentum) * omega_by_momentum - Cross(omega) -
                                   mass * (Cross(u) * (r_by_gamma * gamma_rate_by_momentum) +
                                           Cross(r_rate) * Cross(r) * omega_by_momentum);
  jacobian.topRightCorner<3, 3>() =
      Cross(momentum) * omega_by_gamma +
      mass * (Cross(r_rate) * u_by_gamma - Cross(u) * r_rate_by_gamma) +
      mass * parameters_.gravity * (Cross(r) - Cross(gamma) * r_by_gamma);
  jacobian.bottomLeftCorner<3, 3>() = gamma_rate_by_momentum;
  jacobian.bottomRightCorner<3, 3>() = gamma_rate_by_gamma;
  return jacobian;
}

double CelticStone::Energy(const StoneState& state) const {
  return 0.5 * state.head<3>().dot(AngularVelocity(state)) + Potential(state.tail<3>());
}

StoneState CelticStone::EnergyGradient(const StoneState& state) const {
  const Vector3d gamma = state.tail<3>();
  const Vector3d r = ContactPoint(gamma);
  const Vector3d omega = AngularVelocity(state);
  const double mass = parameters_.mass;
  // γ is normal to the surface, (∂r/∂γ)ᵀγ = 0, so the potential changes as if r were constant.
  const Vector3d by_contact = -mass * (omega.squaredNorm() * r - r.dot(omega) * omega);
  StoneState gradient;
  gradient << omega,
      ContactJacobian(parameters_, gamma).transpose() * by_contact - mass * parameters_.gravity * r;
  return gradient;
}

double CelticStone::Potential(const Vector3d& gamma) const {
  return -parameters_.mass * parameters_.gravity * ContactPoint(gamma).dot(gamma);
}

}  // namespace celt
