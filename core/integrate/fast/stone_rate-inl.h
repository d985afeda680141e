// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// The stone's equations of motion and their linearization in (ω, q), q = (γ₁, γ₂)/γ₃, written once
// for any number of lanes.
//
// With M = Aω, A = I + m(|r|² − rrᵀ), the equations of celtic_stone.h become, divided by m,
//
//     A ω̇ = b = Jω×ω + ρ z − η ω + G k,     q̇ = p,
//     p₁ = q₂ω₃ − ω₂ − q₁u,   p₂ = ω₁ − q₁ω₃ − q₂u,   u = q₁ω₂ − q₂ω₁ = γ̇₃/γ₃,
//     r = (−a₁q₁, −a₂q₂, −h + (a₁q₁² + a₂q₂²)/2),
//     ρ = r·ω,   z = ṙ + ω×r,   η = r·ṙ,   G = g γ₃ = ±g (1 + q₁² + q₂²)^(−1/2),   k = r×(q₁, q₂,
//     1),
//
// where now J = I/m and A = J + |r|² − rrᵀ; this is ṙ×(ω×r) and (d/dt A)ω written out, with
// r×(ṙ×ω) = ρṙ − ηω and M×ω = Jω×ω − ρ r×ω. Both z and η are linear in ω for given q: z = Zω,
//
//     Z = ( r₁q₂              a₁ + r₃ − r₁q₁   (a₂−a₁)q₂ )      η = f₁p₁ + f₂p₂ = e·ω,
//         ( −a₂ − r₃ + r₂q₂   −r₂q₁            (a₂−a₁)q₁ )      f = (−r₁(a₁+r₃), −r₂(a₂+r₃)),
//         ( −q₂x              q₁x              −k₃       )      x = r₁q₁ + r₂q₂,
//     e = (q₂y + f₂, −f₁ − q₁y, f₁q₂ − f₂q₁),   y = f₁q₁ + f₂q₂,
//
// and ∂k/∂q₁, ∂k/∂q₂ are the first two rows of Z; f is also r·∂r/∂q.
//
// A tangent (δω, δq) obeys A δω̇ = B δω + C δq, with the symmetric A solved by its adjugate,
//
//     B = ∂b/∂ω = N + ρ Z + z rᵀ − η − ω eᵀ,   N = ∂(Jω×ω)/∂ω,   C = ∂b/∂q − (∂A/∂q) ω̇.
//
// Scaled time. Everything is advanced in τ with
//
//     dt/dτ = s = (|ω|² + β|q̇|² + c tr A/det A)^(−1/2),
//
// in which the steps that a given accuracy takes are nearly equal; then s A⁻¹ is adj A over
// (D (D(|ω|² + β|q̇|²) + c tr A))^(1/2), D = det A: one root and one division for both. The tangents
// are those of the flow in time t, at equal t: δ' = s · (their rate in t). Their equation has no
// derivative of s.
#if defined(CELT_FAST_STONE_RATE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_STONE_RATE_INL_H_
#undef CELT_FAST_STONE_RATE_INL_H_
#else
#define CELT_FAST_STONE_RATE_INL_H_
#endif

#include <type_traits>

#include "core/integrate/fast/pack-inl.h"
#include "core/integrate/fast/stone_constants.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

/// Components of a state or of a tangent vector: ω₁, ω₂, ω₃, q₁, q₂.
inline constexpr int kComponents = 5;

/// The step in τ: its length, one over it, and the side g γ₃/|γ₃| that the vertical is on.
template <class V>
struct Stride {
  V length;
  V inverse;
  V gravity;
};

/// What the tangents need to know of the state.
template <class V>
struct Linearization {
  V inverse[6];  ///< h s A⁻¹: entries 11, 12, 13, 22, 23, 33
  V b[3][3];     ///< B
  V c[3][2];     ///< C
  V w1, w2, w3, q1, q2, u;
  V scale;  ///< h s
};

/// r and A, and what goes with them.
template <class V>
struct Contact {
  HWY_INLINE Contact(const StoneConstants& k, V q1, V q2)
      : r1(Set<V>(-k.a1) * q1), r2(Set<V>(-k.a2) * q2), r1q1(r1 * q1) {
    x = Fma(r2, q2, r1q1);
    r3 = Fnma(Set<V>(0.5), x, Set<V>(-k.height));
    s1 = r1 * r1;
    s2 = r2 * r2;
    const V s3 = r3 * r3;
    a11 = (Set<V>(k.j11) + s2) + s3;
    a22 = (Set<V>(k.j22) + s1) + s3;
    a33 = (Set<V>(k.j33) + s1) + s2;
    r12 = r1 * r2;
    a12 = Set<V>(k.j12) - r12;
    n13 = r1 * r3;
    n23 = r2 * r3;
  }
  V r1, r2, r3, r1q1, x;
  V s1, s2, r12;                   // r₁², r₂², r₁r₂
  V a11, a22, a33, a12, n13, n23;  // A; n = −a
};

/// hs·(ω̇, q̇) and hs, the time that goes by per step of this rate. With `linear`, also what the
/// tangents need. One formula after another without a branch: cut in pieces it would not read
/// better.
// NOLINTBEGIN(readability-function-size)
template <bool kLinear, class V>
HWY_INLINE void Rate(const StoneConstants& k, const Stride<V>& stride, const V* HWY_RESTRICT state,
                     V* HWY_RESTRICT rate, V& time, Linearization<V>& linear) {
  const V w1 = state[0], w2 = state[1], w3 = state[2], q1 = state[3], q2 = state[4];
  const V one = Set<V>(1);
  const Contact<V> t(k, q1, q2);
  const V r1 = t.r1, r2 = t.r2, r3 = t.r3, x = t.x;

  // Rolling.
  const V u = Fms(q1, w2, q2 * w1);
  const V p1 = Fnma(q1, u, Fms(q2, w3, w2));
  const V p2 = Fnma(q2, u, Fnma(q1, w3, w1));
  const V rho = Fma(r3, w3, Fma(r2, w2, r1 * w1));
  const V e1r3 = Set<V>(k.a1) + r3;
  const V e2r3 = Set<V>(k.a2) + r3;
  const V nf1 = r1 * e1r3;  // −f
  const V nf2 = r2 * e2r3;
  const V neta = Fma(nf2, p2, nf1 * p1);
  const V z11 = r1 * q2;
  const V z12 = e1r3 - t.r1q1;
  const V z13 = Set<V>(k.a21) * q2;
  const V z21 = Fms(r2, q2, e2r3);
  const V nz22 = r2 * q1;
  const V z23 = Set<V>(k.a21) * q1;
  const V k1 = Fnma(r3, q2, r2);
  const V k2 = Fms(r3, q1, r1);
  const V k3 = z11 - nz22;
  const V z1 = Fma(z13, w3, Fma(z12, w2, z11 * w1));
  const V z2 = Fma(z23, w3, Fnma(nz22, w2, z21 * w1));
  const V z3 = Fnma(k3, w3, x * u);

  // Right-hand side b.
  const V y1 = Fma(Set<V>(k.j12), w2, Set<V>(k.j11) * w1);
  const V y2 = Fma(Set<V>(k.j22), w2, Set<V>(k.j12) * w1);
  const V y3 = Set<V>(k.j33) * w3;
  const V gamma = one / Sqrt(Fma(q2, q2, Fma(q1, q1, one)));
  const V gravity = stride.gravity * gamma;
  const V b1 = Fma(gravity, k1, Fma(neta, w1, Fma(rho, z1, Fms(y2, w3, y3 * w2))));
  const V b2 = Fma(gravity, k2, Fma(neta, w2, Fma(rho, z2, Fms(y3, w1, y1 * w3))));
  const V b3 = Fma(gravity, k3, Fma(neta, w3, Fma(rho, z3, Fms(y1, w2, y2 * w1))));

  // h s A⁻¹.
  V c11 = Fms(t.a22, t.a33, t.n23 * t.n23);
  V c12 = Fms(t.n13, t.n23, t.a12 * t.a33);
  V c13 = Fms(t.n13, t.a22, t.a12 * t.n23);
  V c22 = Fms(t.a11, t.a33, t.n13 * t.n13);
  V c23 = Fms(t.a11, t.n23, t.a12 * t.n13);
  V c33 = Fms(t.a11, t.a22, t.a12 * t.a12);
  const V determinant = Fnma(t.n13, c13, Fma(t.a12, c12, t.a11 * c11));
  const V spin = Fma(w3, w3, Fma(w2, w2, w1 * w1));
  const V roll = Fma(p2, p2, p1 * p1);
  const V trace = (t.a11 + t.a22) + t.a33;
  const V hurry = Fma(Set<V>(k.pace_roll), roll, spin);
  const V pace = Fma(determinant, hurry, Set<V>(k.pace_rest) * trace);
  const V root = one / Sqrt(determinant * pace);
  const V factor = stride.length * root;
  c11 = c11 * factor;
  c12 = c12 * factor;
  c13 = c13 * factor;
  c22 = c22 * factor;
  c23 = c23 * factor;
  c33 = c33 * factor;

  const V scale = determinant * factor;
  const V d1 = Fma(c13, b3, Fma(c12, b2, c11 * b1));
  const V d2 = Fma(c23, b3, Fma(c22, b2, c12 * b1));
  const V d3 = Fma(c33, b3, Fma(c23, b2, c13 * b1));
  rate[0] = d1;
  rate[1] = d2;
  rate[2] = d3;
  rate[3] = scale * p1;
  rate[4] = scale * p2;
  time = scale;
  if constexpr (kLinear) {
    linear.inverse[0] = c11;
    linear.inverse[1] = c12;
    linear.inverse[2] = c13;
    linear.inverse[3] = c22;
    linear.inverse[4] = c23;
    linear.inverse[5] = c33;
    linear.w1 = w1;
    linear.w2 = w2;
    linear.w3 = w3;
    linear.q1 = q1;
    linear.q2 = q2;
    linear.u = u;
    linear.scale = scale;

    // B, with −e.
    const V j11 = Set<V>(k.j11), j12 = Set<V>(k.j12), j22 = Set<V>(k.j22), j33 = Set<V>(k.j33);
    const V ny = Fma(nf2, q2, nf1 * q1);
    const V e1 = Fma(q2, ny, nf2);
    const V e2 = Fnms(q1, ny, nf1);
    const V e3 = Fms(nf1, q2, nf2 * q1);
    const V j12w2 = j12 * w2, j12w1 = j12 * w1, j12w3 = j12 * w3;
    const V nz31 = q2 * x, z32 = q1 * x;
    linear.b[0][0] = Fma(w1, e1, Fma(z1, r1, Fma(rho, z11, j12w3 + neta)));
    linear.b[0][1] = Fma(w1, e2, Fma(z1, r2, Fma(rho, z12, Fms(j22, w3, y3))));
    linear.b[0][2] = Fma(w1, e3, Fma(z1, r3, Fma(rho, z13, Fnma(j33, w2, y2))));
    linear.b[1][0] = Fma(w2, e1, Fma(z2, r1, Fma(rho, z21, Fnma(j11, w3, y3))));
    linear.b[1][1] = Fma(w2, e2, Fma(z2, r2, Fnma(rho, nz22, neta - j12w3)));
    linear.b[1][2] = Fma(w2, e3, Fma(z2, r3, Fma(rho, z23, Fms(j33, w1, y1))));
    linear.b[2][0] = Fma(w3, e1, Fma(z3, r1, Fnma(rho, nz31, Fms(j11, w2, y2 + j12w1))));
    linear.b[2][1] = Fma(w3, e2, Fma(z3, r2, Fma(rho, z32, Fnma(j22, w1, y1 + j12w2))));
    linear.b[2][2] = Fma(w3, e3, Fma(z3, r3, Fnma(rho, k3, neta)));

    // C.
    const V over = stride.inverse * (root * pace);  // 1/(hs)
    const V alpha1 = d1 * over, alpha2 = d2 * over, alpha3 = d3 * over;
    const V a1 = Set<V>(k.a1), a2 = Set<V>(k.a2), a21 = Set<V>(k.a21);
    const V nrho1 = Fma(r1, w3, a1 * w1);  // −∂ρ/∂q
    const V nrho2 = Fma(r2, w3, a2 * w2);
    const V m1 = Fnms(q1, w2, u), m2 = Fma(q1, w1, w3);  // ∂p/∂q
    const V m3 = Fnms(q2, w2, w3), m4 = Fms(q2, w1, u);
    const V f11 = Fma(a1, e1r3, t.s1), f22 = Fma(a2, e2r3, t.s2), f12 = t.r12;
    const V eta1 = Fnma(nf2, m3, Fnma(nf1, m1, Fma(f12, p2, f11 * p1)));
    const V eta2 = Fnma(nf2, m4, Fnma(nf1, m2, Fma(f22, p2, f12 * p1)));
    const V cross = Fma(a21, w3, Fnma(r2, w2, r1 * w1));
    const V r1w2 = r1 * w2, r2w1 = r2 * w1;
    const V three = Set<V>(3);
    const V z1q1 = Fnms(three, r1w2, (a1 * q2) * w1);
    const V z2q1 = cross;
    const V z3q1 = Fnma(z13, w3, Fma(x, w2, (r1 + r1) * u));
    const V z1q2 = cross;
    const V z2q2 = Fma(a2 * q1, w2, three * r2w1);
    const V z3q2 = Fnma(z23, w3, Fnma(x, w1, (r2 + r2) * u));
    const V fall = gravity * (gamma * gamma);
    const V g1 = fall * q1, g2 = fall * q2;  // −∂G/∂q
    const V ralpha = Fma(r3, alpha3, Fma(r2, alpha2, r1 * alpha1));
    const V t1 = Fma(r1, alpha3, a1 * alpha1);  // −∂r/∂q·ω̇
    const V t2 = Fma(r2, alpha3, a2 * alpha2);
    const V ff1 = nf1 + nf1, ff2 = nf2 + nf2;
    // ∂b/∂q − (2 f ω̇ − (∂r/∂q)(r·ω̇) − r (∂r/∂q·ω̇))
    const auto column = [&](V nrho, V zq, V eta_q, V zrow, V gq, V z, V w, V kk, V ff, V alpha,
                            V ntau, V r) HWY_ATTR {
      V sum = rho * zq;
      sum = Fnma(nrho, z, sum);
      sum = Fnma(eta_q, w, sum);
      sum = Fma(gravity, zrow, sum);
      sum = Fnma(gq, kk, sum);
      sum = Fma(ff, alpha, sum);
      return Fnma(r, ntau, sum);
    };
    linear.c[0][0] =
        Fnma(a1, ralpha, column(nrho1, z1q1, eta1, z11, g1, z1, w1, k1, ff1, alpha1, t1, r1));
    linear.c[1][0] = column(nrho1, z2q1, eta1, z12, g1, z2, w2, k2, ff1, alpha2, t1, r2);
    linear.c[2][0] =
        Fnma(r1, ralpha, column(nrho1, z3q1, eta1, z13, g1, z3, w3, k3, ff1, alpha3, t1, r3));
    linear.c[0][1] = column(nrho2, z1q2, eta2, z21, g2, z1, w1, k1, ff2, alpha1, t2, r1);
    linear.c[1][1] =
        Fnma(a2, ralpha, column(nrho2, z2q2, eta2, Neg(nz22), g2, z2, w2, k2, ff2, alpha2, t2, r2));
    linear.c[2][1] =
        Fnma(r2, ralpha, column(nrho2, z3q2, eta2, z23, g2, z3, w3, k3, ff2, alpha3, t2, r3));
  }
}
// NOLINTEND(readability-function-size)

/// x in every lane of a T: itself, or a single number spread.
template <class T, class V>
HWY_INLINE T Spread(const V& x) {
  if constexpr (std::is_same_v<T, V>) {
    return x;
  } else {
    return Set<T>(hn::GetLane(x));
  }
}

/// hs·(δω̇, δq̇).
template <class V, class T>
HWY_INLINE void TangentRate(const Linearization<V>& l, const T* HWY_RESTRICT v,
                            T* HWY_RESTRICT rate) {
  const T v1 = v[0], v2 = v[1], v3 = v[2], v4 = v[3], v5 = v[4];
  const auto row = [&](int i) HWY_ATTR {
    const T omega_part =
        Fma(Spread<T>(l.b[i][2]), v3, Fma(Spread<T>(l.b[i][1]), v2, Spread<T>(l.b[i][0]) * v1));
    return Fma(Spread<T>(l.c[i][1]), v5, Fma(Spread<T>(l.c[i][0]), v4, omega_part));
  };
  const T s1 = row(0), s2 = row(1), s3 = row(2);
  const T i11 = Spread<T>(l.inverse[0]), i12 = Spread<T>(l.inverse[1]),
          i13 = Spread<T>(l.inverse[2]);
  const T i22 = Spread<T>(l.inverse[3]), i23 = Spread<T>(l.inverse[4]),
          i33 = Spread<T>(l.inverse[5]);
  rate[0] = Fma(i13, s3, Fma(i12, s2, i11 * s1));
  rate[1] = Fma(i23, s3, Fma(i22, s2, i12 * s1));
  rate[2] = Fma(i33, s3, Fma(i23, s2, i13 * s1));
  const T q1 = Spread<T>(l.q1), q2 = Spread<T>(l.q2), u = Spread<T>(l.u), w3 = Spread<T>(l.w3);
  const T du = Fnma(Spread<T>(l.w1), v5, Fma(Spread<T>(l.w2), v4, Fms(q1, v2, q2 * v1)));
  const T p1 = Fnma(q1, du, Fnma(u, v4, Fma(w3, v5, Fms(q2, v3, v2))));
  const T p2 = Fnma(q2, du, Fnma(u, v5, Fnma(w3, v4, Fnma(q1, v3, v1))));
  const T scale = Spread<T>(l.scale);
  rate[3] = scale * p1;
  rate[4] = scale * p2;
}

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_STONE_RATE_INL_H_
