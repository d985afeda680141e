// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// Between (ω, q) and (M, γ), with the derivative. With A as in stone_rate-inl.h, ρ = r·ω,
// f_j = r·∂r/∂q_j,
//
//     M/m = Aω,   ∂(Aω)/∂q_j = 2 f_j ω − ρ ∂r/∂q_j − r (∂r/∂q_j·ω),
//     γ = γ₃ (q₁, q₂, 1),   δγ = γ₃ (δq₁, δq₂, 0) − γ₃² (q·δq) γ,   δq_j = (δγ_j − q_j δγ₃)/γ₃.
#if defined(CELT_FAST_MOMENTUM_CHART_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_MOMENTUM_CHART_INL_H_
#undef CELT_FAST_MOMENTUM_CHART_INL_H_
#else
#define CELT_FAST_MOMENTUM_CHART_INL_H_
#endif

#include "core/integrate/fast/pack-inl.h"
#include "core/integrate/fast/stone_rate-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

/// Components of (M/m, γ).
inline constexpr int kChartSize = 6;

template <class V>
struct MomentumChart {
  /// `up` is the sign of γ₃.
  HWY_INLINE MomentumChart(const StoneConstants& k, V up, const V* HWY_RESTRICT x)
      : a(k, x[3], x[4]), q1(x[3]), q2(x[4]) {
    const V w1 = x[0], w2 = x[1], w3 = x[2];
    const V a1 = Set<V>(k.a1), a2 = Set<V>(k.a2), two = Set<V>(2);
    const V rho = Fma(a.r3, w3, Fma(a.r2, w2, a.r1 * w1));
    const V nrho1 = Fma(a.r1, w3, a1 * w1);  // −∂r/∂q·ω
    const V nrho2 = Fma(a.r2, w3, a2 * w2);
    const V nf1 = two * (a.r1 * (a1 + a.r3));  // −2f
    const V nf2 = two * (a.r2 * (a2 + a.r3));
    by_q[0][0] = Fma(a.r1, nrho1, Fnma(nf1, w1, a1 * rho));
    by_q[1][0] = Fnma(nf1, w2, a.r2 * nrho1);
    by_q[2][0] = Fma(a.r3, nrho1, Fnma(nf1, w3, a.r1 * rho));
    by_q[0][1] = Fnma(nf2, w1, a.r1 * nrho2);
    by_q[1][1] = Fma(a.r2, nrho2, Fnma(nf2, w2, a2 * rho));
    by_q[2][1] = Fma(a.r3, nrho2, Fnma(nf2, w3, a.r2 * rho));
    Inertia(x, state);
    const V one = Set<V>(1);
    gamma3 = up / Sqrt(Fma(q2, q2, Fma(q1, q1, one)));
    state[3] = gamma3 * q1;
    state[4] = gamma3 * q2;
    state[5] = gamma3;
  }

  /// (δM/m, δγ) of (δω, δq).
  template <class T>
  HWY_INLINE void Push(const T* HWY_RESTRICT v, T* HWY_RESTRICT out) const {
    Inertia(v, out);
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      out[i] = Fma(Spread<T>(by_q[i][1]), v[4], Fma(Spread<T>(by_q[i][0]), v[3], out[i]));
    }
    const T up = Spread<T>(gamma3);
    const T turn = up * Fma(Spread<T>(q2), v[4], Spread<T>(q1) * v[3]);
    out[3] = up * Fnma(turn, Spread<T>(state[3]), v[3]);
    out[4] = up * Fnma(turn, Spread<T>(state[4]), v[4]);
    out[5] = Neg(up * (turn * up));
  }

  V state[kChartSize];  ///< (M/m, γ)
  Contact<V> a;
  V q1, q2, gamma3;
  V by_q[3][2];

 private:
  /// A times the first three components.
  template <class T>
  HWY_INLINE void Inertia(const T* HWY_RESTRICT v, T* HWY_RESTRICT out) const {
    const T a12 = Spread<T>(a.a12), n13 = Spread<T>(a.n13), n23 = Spread<T>(a.n23);
    out[0] = Fnma(n13, v[2], Fma(a12, v[1], Spread<T>(a.a11) * v[0]));
    out[1] = Fnma(n23, v[2], Fma(Spread<T>(a.a22), v[1], a12 * v[0]));
    out[2] = Fma(Spread<T>(a.a33), v[2], Fnms(n23, v[1], n13 * v[0]));
  }
};

/// A⁻¹, by its adjugate.
template <class V>
struct InverseInertia {
  InverseInertia() = default;
  HWY_INLINE explicit InverseInertia(const Contact<V>& a) {
    i11 = Fms(a.a22, a.a33, a.n23 * a.n23);
    i12 = Fms(a.n13, a.n23, a.a12 * a.a33);
    i13 = Fms(a.n13, a.a22, a.a12 * a.n23);
    const V over = Set<V>(1) / Fnma(a.n13, i13, Fma(a.a12, i12, a.a11 * i11));
    i11 = i11 * over;
    i12 = i12 * over;
    i13 = i13 * over;
    i22 = Fms(a.a11, a.a33, a.n13 * a.n13) * over;
    i23 = Fms(a.a11, a.n23, a.a12 * a.n13) * over;
    i33 = Fms(a.a11, a.a22, a.a12 * a.a12) * over;
  }

  template <class T>
  HWY_INLINE void Apply(const T* HWY_RESTRICT m, T* HWY_RESTRICT out) const {
    const T t12 = Spread<T>(i12), t13 = Spread<T>(i13), t23 = Spread<T>(i23);
    out[0] = Fma(t13, m[2], Fma(t12, m[1], Spread<T>(i11) * m[0]));
    out[1] = Fma(t23, m[2], Fma(Spread<T>(i22), m[1], t12 * m[0]));
    out[2] = Fma(Spread<T>(i33), m[2], Fma(t23, m[1], t13 * m[0]));
  }

  V i11, i12, i13, i22, i23, i33;
};

/// The way back, from a state (M/m, γ) with γ₃ ≠ 0. |γ| is taken as 1.
template <class V>
struct VelocityChart {
  HWY_INLINE VelocityChart(const StoneConstants& k, const V* HWY_RESTRICT state)
      : over_gamma3(Set<V>(1) / state[5]) {
    x[3] = state[3] * over_gamma3;
    x[4] = state[4] * over_gamma3;
    inverse = InverseInertia<V>(Contact<V>(k, x[3], x[4]));
    inverse.Apply(state, x);
    const V up = IfLessEqual(Set<V>(0), state[5], Set<V>(1), Set<V>(-1));
    const MomentumChart<V> back(k, up, x);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 2; ++j) by_q[i][j] = back.by_q[i][j];
    }
  }

  /// (δω, δq) of (δM/m, δγ), which is tangent to |γ| = 1; what it has along γ is dropped.
  template <class T>
  HWY_INLINE void Push(const T* HWY_RESTRICT v, T* HWY_RESTRICT out) const {
    const T over = Spread<T>(over_gamma3);
    out[3] = Fnma(Spread<T>(x[3]), v[5], v[3]) * over;
    out[4] = Fnma(Spread<T>(x[4]), v[5], v[4]) * over;
    T m[3];
    for (int i = 0; i < 3; ++i) {
      m[i] = Fnma(Spread<T>(by_q[i][1]), out[4], Fnma(Spread<T>(by_q[i][0]), out[3], v[i]));
    }
    inverse.Apply(m, out);
  }

  V over_gamma3;
  V x[kComponents];  ///< (ω, q)
  InverseInertia<V> inverse;
  V by_q[3][2];
};

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_MOMENTUM_CHART_INL_H_
