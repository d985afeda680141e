#include "tests/bench/chart.h"

#include <cmath>

#include "Eigen/LU"

namespace celt::bench {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// The parts of the chart: M = Aω, γ = γ₃ (q₁, q₂, 1).
struct Parts {
  Matrix3d inertia;                        ///< A
  Eigen::Matrix<double, 3, 2> by_tilt;     ///< (∂A/∂q) ω
  Eigen::Matrix<double, 3, 2> gamma_by_q;  ///< ∂γ/∂q
  Vector3d gamma;
};

Parts PartsAt(const CelticStone& stone, const FastState& x, double up) {
  const StoneParameters& p = stone.parameters();
  const double q1 = x[3];
  const double q2 = x[4];
  const double bulge = p.radius1 * q1 * q1 + p.radius2 * q2 * q2;
  const Vector3d r(-p.radius1 * q1, -p.radius2 * q2, 0.5 * bulge - p.height);
  Eigen::Matrix<double, 3, 2> r_by_q;
  r_by_q << -p.radius1, 0, 0, -p.radius2, p.radius1 * q1, p.radius2 * q2;
  const Vector3d omega = x.head<3>();

  Parts parts;
  parts.inertia = stone.inertia();
  parts.inertia.noalias() -= p.mass * r * r.transpose();
  parts.inertia.diagonal().array() += p.mass * r.squaredNorm();
  // dA ω = m(2(r·dr)ω − dr(r·ω) − r(dr·ω))
  for (int j = 0; j < 2; ++j) {
    const Vector3d dr = r_by_q.col(j);
    parts.by_tilt.col(j) = p.mass * (2 * r.dot(dr) * omega - r.dot(omega) * dr - dr.dot(omega) * r);
  }
  const double gamma3 = up / std::sqrt(1 + q1 * q1 + q2 * q2);
  parts.gamma = gamma3 * Vector3d(q1, q2, 1);
  for (int j = 0; j < 2; ++j) {
    parts.gamma_by_q.col(j) = gamma3 * Vector3d::Unit(j) - gamma3 * gamma3 * x[3 + j] * parts.gamma;
  }
  return parts;
}

}  // namespace

Chart ToMomentum(const CelticStone& stone, const FastState& x, double up) {
  const Parts parts = PartsAt(stone, x, up);
  Chart chart;
  chart.state << parts.inertia * x.head<3>(), parts.gamma;
  chart.derivative << parts.inertia, parts.by_tilt, Matrix3d::Zero(), parts.gamma_by_q;
  return chart;
}

FastState FromMomentum(const CelticStone& stone, const StoneState& state) {
  FastState x;
  x << stone.AngularVelocity(state), state[3] / state[5], state[4] / state[5];
  return x;
}

FastTangents FromMomentum(const CelticStone& stone, const FastState& x, double up,
                          const StoneTangents& tangents) {
  const Parts parts = PartsAt(stone, x, up);
  const double gamma3 = parts.gamma[2];
  FastTangents out;
  for (int j = 0; j < 2; ++j) {
    out.row(3 + j) = (tangents.row(3 + j) - x[3 + j] * tangents.row(5)) / gamma3;
  }
  out.topRows<3>() =
      parts.inertia.inverse() * (tangents.topRows<3>() - parts.by_tilt * out.bottomRows<2>());
  return out;
}

}  // namespace celt::bench
