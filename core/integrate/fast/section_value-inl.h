// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// Where an orbit is with respect to the section g = g₀, in (ω, q). But for a positive factor, the e
// of section_event.h and its side are, with q̂ = (q₁, q₂, 1) and M = Aω,
//
//     e = S cos g₀ − C sin g₀,   side = S sin g₀ + C cos g₀,
//     S = ±|M| (M₂q₁ − M₁q₂),   C = ±(M₃ (M·q̂) − |M|²),   ± the sign of γ₃.
#if defined(CELT_FAST_SECTION_VALUE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_SECTION_VALUE_INL_H_
#undef CELT_FAST_SECTION_VALUE_INL_H_
#else
#define CELT_FAST_SECTION_VALUE_INL_H_
#endif

#include "core/integrate/fast/coordinates.h"
#include "core/integrate/fast/lanes.h"
#include "core/integrate/fast/pack-inl.h"
#include "core/integrate/fast/stone_rate-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

template <class V>
struct SectionPlace {
  V value;  ///< e: vanishes on the section
  V side;   ///< positive on the section, negative half a turn away from it
};

/// M/m.
template <class V>
HWY_INLINE void Momentum(const StoneConstants& constants, const V* HWY_RESTRICT state,
                         V* HWY_RESTRICT m) {
  const Contact<V> a(constants, state[3], state[4]);
  m[0] = Fnma(a.n13, state[2], Fma(a.a12, state[1], a.a11 * state[0]));
  m[1] = Fnma(a.n23, state[2], Fma(a.a22, state[1], a.a12 * state[0]));
  m[2] = Fma(a.a33, state[2], Fnms(a.n23, state[1], a.n13 * state[0]));
}

/// `up` has the sign of γ₃.
template <class V>
HWY_INLINE SectionPlace<V> Locate(const StoneConstants& constants, double cosine, double sine, V up,
                                  const V* HWY_RESTRICT state) {
  V m[3];
  Momentum(constants, state, m);
  const V q1 = state[3], q2 = state[4];
  const V square = Fma(m[2], m[2], Fma(m[1], m[1], m[0] * m[0]));
  const V along = Fma(m[1], q2, Fma(m[0], q1, m[2]));
  const V s = Fms(m[1], q1, m[0] * q2) * (Sqrt(square) * up);
  const V c = Fms(m[2], along, square) * up;
  const V cos = Set<V>(cosine), sin = Set<V>(sine);
  return {Fms(s, cos, c * sin), Fma(s, sin, c * cos)};
}

/// The same for one orbit.
HWY_INLINE SectionPlace<double> PlaceAt(const Problem& problem, const FastState& x,
                                        double gravity) {
  using One = Lanes<1>;
  One state[kComponents];
  for (int i = 0; i < kComponents; ++i) state[i] = Set<One>(x[i]);
  const SectionPlace<One> place = Locate(problem.constants, problem.event.cosine(),
                                         problem.event.sine(), Set<One>(gravity), state);
  return {hn::GetLane(place.value), hn::GetLane(place.side)};
}

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_SECTION_VALUE_INL_H_
