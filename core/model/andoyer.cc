#include "core/model/andoyer.h"

#include <cmath>

#include "Eigen/LU"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "core/model/angle.h"

namespace celt {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Unit momentum m̂ and vertical γ as functions of x = (l, p, q) = (l, L/G, H/G) at constant g, with
/// derivatives.
struct Directions {
  Vector3d momentum;
  Vector3d gamma;
  Matrix3d momentum_by_x;
  Matrix3d gamma_by_x;
};

Directions DirectionsOf(const SectionPoint& x, double g) {
  const double sin_l = std::sin(x[0]);
  const double cos_l = std::cos(x[0]);
  const double cos_g = std::cos(g);
  const double sin_g = std::sin(g);
  const double p = x[1];
  const double q = x[2];
  const double s = std::sqrt(1 - p * p);
  const double c = std::sqrt(1 - q * q);
  // γ in the horizontal axes turned by l: `along` the horizontal part of the momentum, `across` it.
  const double along = q * s + p * c * cos_g;
  const double across = c * sin_g;
  const double along_by_p = -q * p / s + c * cos_g;
  const double along_by_q = s - p * q / c * cos_g;
  const double across_by_q = -q / c * sin_g;

  Directions d;
  d.momentum << s * sin_l, s * cos_l, p;
  d.momentum_by_x << s * cos_l, -p / s * sin_l, 0,  //
      -s * sin_l, -p / s * cos_l, 0,                //
      0, 1, 0;
  d.gamma << along * sin_l + across * cos_l, along * cos_l - across * sin_l, q * p - s * c * cos_g;
  d.gamma_by_x << d.gamma.y(), along_by_p * sin_l, along_by_q * sin_l + across_by_q * cos_l,  //
      -d.gamma.x(), along_by_p * cos_l, along_by_q * cos_l - across_by_q * sin_l,             //
      0, q + p / s * c * cos_g, p + s * q / c * cos_g;
  return d;
}

absl::Status CheckCoordinate(absl::string_view name, double value) {
  if (std::abs(value) < 1) return absl::OkStatus();  // false for NaN
  return absl::InvalidArgumentError(
      absl::StrCat(name, ": ", value, " is not allowed; must lie in (-1, 1)"));
}

absl::Status CheckPoint(const SectionPoint& x) {
  absl::Status status;
  if (!std::isfinite(x[0])) {
    status =
        absl::InvalidArgumentError(absl::StrCat("l: ", x[0], " is not allowed; must be finite"));
  }
  status.Update(CheckCoordinate("l_over_g", x[1]));
  status.Update(CheckCoordinate("h_over_g", x[2]));
  return status;
}

absl::string_view Where(const SectionPoint& x, std::string& buffer) {
  buffer = absl::StrCat("l = ", x[0], ", l_over_g = ", x[1], ", h_over_g = ", x[2]);
  return buffer;
}

absl::Status CheckLevel(const CelticStone& stone, double energy, const SectionPoint& x,
                        const Vector3d& gamma) {
  std::string where;
  if (!(std::abs(gamma.z()) >= kLeastGamma3)) {
    return absl::InvalidArgumentError(
        absl::StrCat("start: gamma3 = ", gamma.z(), " at ", Where(x, where),
                     " is not allowed; |gamma3| must be at least ", kLeastGamma3));
  }
  const double potential = stone.Potential(gamma);
  if (!std::isfinite(energy) || energy <= potential) {
    return absl::InvalidArgumentError(
        absl::StrCat("energy: ", energy, " is not allowed at ", Where(x, where),
                     "; must be finite and above the potential energy there, ", potential));
  }
  return absl::OkStatus();
}

}  // namespace

Andoyer ToAndoyer(const StoneState& state) {
  const Vector3d momentum = state.head<3>();
  const Vector3d gamma = state.tail<3>();
  Andoyer a;
  a.L = momentum.z();
  a.H = momentum.dot(gamma);
  a.G = momentum.norm();
  a.l = WrapToTurn(std::atan2(momentum.x(), momentum.y()));
  const double sine = momentum.y() * gamma.x() - momentum.x() * gamma.y();
  const double cosine = (a.L * a.H - a.G * a.G * gamma.z()) / a.G;
  a.g = WrapToTurn(std::atan2(sine, cosine));
  return a;
}

StoneState FromAndoyer(const Andoyer& andoyer) {
  const Directions d =
      DirectionsOf({andoyer.l, andoyer.L / andoyer.G, andoyer.H / andoyer.G}, andoyer.g);
  StoneState state;
  state << andoyer.G * d.momentum, d.gamma;
  return state;
}

absl::StatusOr<LiftedPoint> LiftToLevel(const CelticStone& stone, double energy,
                                        double section_angle, const SectionPoint& x) {
  if (absl::Status status = CheckPoint(x); !status.ok()) return status;
  const Directions d = DirectionsOf(x, section_angle);
  if (absl::Status status = CheckLevel(stone, energy, x, d.gamma); !status.ok()) return status;

  // On the level ½G² T + V(γ) = E, where T(m̂, γ) = (m̂, A⁻¹m̂) is twice the energy of a unit
  // momentum.
  StoneState unit;
  unit << d.momentum, d.gamma;
  const double unit_energy = d.momentum.dot(stone.AngularVelocity(unit));
  const double G = std::sqrt(2 * (energy - stone.Potential(d.gamma)) / unit_energy);

  LiftedPoint lifted;
  lifted.state << G * d.momentum, d.gamma;
  lifted.derivative << G * d.momentum_by_x, d.gamma_by_x;
  // So far G was held; H = E takes it along: ∂H/∂G · dG = −(rest of dH), with ∂H/∂G = (ω, m̂).
  const StoneState gradient = stone.EnergyGradient(lifted.state);
  const double by_size = gradient.head<3>().dot(d.momentum);
  const Eigen::RowVector3d size_by_x = -gradient.transpose() * lifted.derivative / by_size;
  lifted.derivative.topRows<3>() += d.momentum * size_by_x;
  if (!lifted.state.allFinite() || !lifted.derivative.allFinite()) {
    return absl::InvalidArgumentError(
        absl::StrCat("energy: ", energy, " is not allowed; too large for double precision"));
  }
  return lifted;
}

ProjectedState ProjectToSection(const StoneState& state) {
  const Vector3d momentum = state.head<3>();
  const Vector3d gamma = state.tail<3>();
  const double G = momentum.norm();
  const Vector3d unit = momentum / G;
  const double p = unit.z();
  const double q = unit.dot(gamma);
  const double horizontal2 = momentum.x() * momentum.x() + momentum.y() * momentum.y();

  ProjectedState projected;
  projected.x << WrapToTurn(std::atan2(momentum.x(), momentum.y())), p, q;
  projected.derivative.setZero();
  projected.derivative.row(0).head<2>() << momentum.y() / horizontal2, -momentum.x() / horizontal2;
  projected.derivative.row(1).head<3>() = (Vector3d::UnitZ() - p * unit).transpose() / G;
  projected.derivative.row(2) << (gamma - q * unit).transpose() / G, unit.transpose();
  return projected;
}

SectionPoint ExchangeFrame(const SectionPoint& x, double delta) {
  return {WrapToTurn(-(x[0] + delta)), -x[1], x[2]};
}

}  // namespace celt
