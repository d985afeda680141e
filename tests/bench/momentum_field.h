#pragma once

// MomentumEquations as plain functions: what a careful user writes from the equations of
// celtic_stone.h, with each tangent by the chain rule. With q = (γ₁, γ₂)/γ₃,
//
//     r = (−a₁q₁, −a₂q₂, −h + (a₁q₁² + a₂q₂²)/2),   M = Aω = Iω + m r×(ω×r),
//     γ̇ = γ×ω,   Ṁ = M×ω + m ṙ×(ω×r) + m g r×γ.
//
// For one source file alone, which says what machine they are compiled for.

#include <cmath>

#include "tests/bench/odeint_crossing.h"
#include "tests/bench/place.h"

namespace celt::bench {
namespace {

struct Vector {
  double x, y, z;
};

inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector operator*(double s, Vector a) { return {s * a.x, s * a.y, s * a.z}; }
inline double Dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector Cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Vector Get(const double* x) { return {x[0], x[1], x[2]}; }
inline void Put(Vector a, double* x) {
  x[0] = a.x;
  x[1] = a.y;
  x[2] = a.z;
}

/// A⁻¹ of A = I + m(|r|² − rrᵀ).
struct InverseInertia {
  InverseInertia(const MomentumEquations& e, Vector r) {
    const double m = e.stone.mass;
    const double a11 = e.inertia11 + m * (r.y * r.y + r.z * r.z);
    const double a22 = e.inertia22 + m * (r.x * r.x + r.z * r.z);
    const double a33 = e.stone.inertia3 + m * (r.x * r.x + r.y * r.y);
    const double a12 = e.inertia12 - m * r.x * r.y;
    const double a13 = -m * r.x * r.z;
    const double a23 = -m * r.y * r.z;
    const double c11 = a22 * a33 - a23 * a23;
    const double c12 = a13 * a23 - a12 * a33;
    const double c13 = a12 * a23 - a13 * a22;
    const double over = 1 / (a11 * c11 + a12 * c12 + a13 * c13);
    row1 = over * Vector{c11, c12, c13};
    row2 = over * Vector{c12, a11 * a33 - a13 * a13, a12 * a13 - a11 * a23};
    row3 = over * Vector{c13, a12 * a13 - a11 * a23, a11 * a22 - a12 * a12};
  }
  Vector operator*(Vector b) const { return {Dot(row1, b), Dot(row2, b), Dot(row3, b)}; }
  Vector row1, row2, row3;
};

/// The rate of a state and of the tangents behind it.
template <int kTangents>
void Rate(const MomentumEquations& equations, const double* x, double* rate) {
  const StoneParameters& p = equations.stone;
  const double m = p.mass;
  const Vector momentum = Get(x);
  const Vector gamma = Get(x + 3);
  const double inverse = 1 / gamma.z;
  const double q1 = gamma.x * inverse;
  const double q2 = gamma.y * inverse;
  const Vector r = {-p.radius1 * q1, -p.radius2 * q2,
                    -p.height + 0.5 * (p.radius1 * q1 * q1 + p.radius2 * q2 * q2)};
  // (∂r/∂q) v
  const auto turn = [&](double v1, double v2) {
    return Vector{-p.radius1 * v1, -p.radius2 * v2, p.radius1 * q1 * v1 + p.radius2 * q2 * v2};
  };
  const InverseInertia solve(equations, r);
  const Vector omega = solve * momentum;
  const Vector gamma_rate = Cross(gamma, omega);
  const double q1_rate = (gamma_rate.x - q1 * gamma_rate.z) * inverse;
  const double q2_rate = (gamma_rate.y - q2 * gamma_rate.z) * inverse;
  const Vector r_rate = turn(q1_rate, q2_rate);
  const Vector u = Cross(omega, r);
  Put(Cross(momentum, omega) + m * Cross(r_rate, u) + (m * p.gravity) * Cross(r, gamma), rate);
  Put(gamma_rate, rate + 3);

  for (int j = 1; j <= kTangents; ++j) {
    const Vector d_momentum = Get(x + 6 * j);
    const Vector d_gamma = Get(x + 6 * j + 3);
    const double dq1 = (d_gamma.x - q1 * d_gamma.z) * inverse;
    const double dq2 = (d_gamma.y - q2 * d_gamma.z) * inverse;
    const Vector dr = turn(dq1, dq2);
    const Vector d_inertia_omega =
        m * (2 * Dot(r, dr) * omega - Dot(r, omega) * dr - Dot(dr, omega) * r);
    const Vector d_omega = solve * (d_momentum - d_inertia_omega);
    const Vector dg = Cross(d_gamma, omega) + Cross(gamma, d_omega);
    const double dq1_rate = (dg.x - dq1 * gamma_rate.z - q1 * dg.z - q1_rate * d_gamma.z) * inverse;
    const double dq2_rate = (dg.y - dq2 * gamma_rate.z - q2 * dg.z - q2_rate * d_gamma.z) * inverse;
    Vector dr_rate = turn(dq1_rate, dq2_rate);
    dr_rate.z += p.radius1 * dq1 * q1_rate + p.radius2 * dq2 * q2_rate;
    const Vector du = Cross(d_omega, r) + Cross(omega, dr);
    Put(Cross(d_momentum, omega) + Cross(momentum, d_omega) +
            m * (Cross(dr_rate, u) + Cross(r_rate, du)) +
            (m * p.gravity) * (Cross(dr, gamma) + Cross(r, d_gamma)),
        rate + 6 * j);
    Put(dg, rate + 6 * j + 3);
  }
}

inline Place PlaceOf(const MomentumEquations& equations, const double* x) {
  const Vector momentum = Get(x);
  const Vector gamma = Get(x + 3);
  const double size = std::sqrt(Dot(momentum, momentum));
  const double s = momentum.y * gamma.x - momentum.x * gamma.y;
  const double c = momentum.z * Dot(momentum, gamma) / size - size * gamma.z;
  return {s * equations.cosine - c * equations.sine, s * equations.sine + c * equations.cosine};
}

}  // namespace
}  // namespace celt::bench
