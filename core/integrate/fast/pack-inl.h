// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// Lanes<N>: N doubles side by side, one for each of N independent orbits. A vector of the machine
// where it is wide enough, else a Pair of halves. Arithmetic is by +, −, ×, /, Fma and the like,
// Sqrt: all correctly rounded and lane by lane, so that what a lane computes does not depend on N.
// Where the machine has no fused multiply-add, Fma rounds twice, for every N alike.
#if defined(CELT_FAST_PACK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_PACK_INL_H_
#undef CELT_FAST_PACK_INL_H_
#else
#define CELT_FAST_PACK_INL_H_
#endif

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class T>
struct Pair {
  T a, b;
};

template <int N>
using Tag = hn::CappedTag<double, N>;

/// Doubles in the machine's longest vector.
inline constexpr int kMaxLanes = static_cast<int>(hn::MaxLanes(hn::ScalableTag<double>()));

template <int N, bool kFits = (N <= hn::MaxLanes(Tag<N>()))>
struct LanesOf {
  using Type = hn::Vec<Tag<N>>;
};
template <int N>
struct LanesOf<N, false> {
  using Type = Pair<typename LanesOf<N / 2>::Type>;
};
template <int N>
using Lanes = typename LanesOf<N>::Type;

/// Number of lanes of a type.
template <class V>
inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(hn::DFromV<V>()));
template <class T>
inline constexpr int kLanes<Pair<T>> = 2 * kLanes<T>;

template <class V>
struct Access {
  static HWY_INLINE V Set(double value) { return hn::Set(hn::DFromV<V>(), value); }
  static HWY_INLINE V Load(const double* from) { return hn::Load(hn::DFromV<V>(), from); }
  static HWY_INLINE void Store(V v, double* to) { hn::Store(v, hn::DFromV<V>(), to); }
};
template <class T>
struct Access<Pair<T>> {
  static HWY_INLINE Pair<T> Set(double value) {
    return {Access<T>::Set(value), Access<T>::Set(value)};
  }
  static HWY_INLINE Pair<T> Load(const double* from) {
    return {Access<T>::Load(from), Access<T>::Load(from + kLanes<T>)};
  }
  static HWY_INLINE void Store(const Pair<T>& v, double* to) {
    Access<T>::Store(v.a, to);
    Access<T>::Store(v.b, to + kLanes<T>);
  }
};
template <class V>
HWY_INLINE V Set(double value) {
  return Access<V>::Set(value);
}
/// `from` is aligned as hwy::AllocateAligned aligns.
template <class V>
HWY_INLINE V Load(const double* from) {
  return Access<V>::Load(from);
}
template <class V>
HWY_INLINE void Store(const V& v, double* to) {
  Access<V>::Store(v, to);
}

/// ab + c
template <class V>
HWY_INLINE V Fma(V a, V b, V c) {
  return hn::MulAdd(a, b, c);
}
/// c − ab
template <class V>
HWY_INLINE V Fnma(V a, V b, V c) {
  return hn::NegMulAdd(a, b, c);
}
/// ab − c
template <class V>
HWY_INLINE V Fms(V a, V b, V c) {
  return hn::MulSub(a, b, c);
}
/// −ab − c
template <class V>
HWY_INLINE V Fnms(V a, V b, V c) {
  return hn::NegMulSub(a, b, c);
}
template <class V>
HWY_INLINE V Sqrt(V a) {
  return hn::Sqrt(a);
}
template <class V>
HWY_INLINE V Neg(V a) {
  return hn::Neg(a);
}
template <class V>
HWY_INLINE V Min(V a, V b) {
  return hn::Min(a, b);
}
template <class V>
HWY_INLINE V Max(V a, V b) {
  return hn::Max(a, b);
}
/// `yes` where a ≤ b, else `no`, also where a or b is NaN.
template <class V>
HWY_INLINE V IfLessEqual(V a, V b, V yes, V no) {
  return hn::IfThenElse(hn::Le(a, b), yes, no);
}
/// Whether a ≤ b in every lane.
template <class V>
HWY_INLINE bool AllLessEqual(V a, V b) {
  return hn::AllTrue(hn::DFromV<V>(), hn::Le(a, b));
}

template <class T>
HWY_INLINE Pair<T> operator+(const Pair<T>& x, const Pair<T>& y) {
  return {x.a + y.a, x.b + y.b};
}
template <class T>
HWY_INLINE Pair<T> operator-(const Pair<T>& x, const Pair<T>& y) {
  return {x.a - y.a, x.b - y.b};
}
template <class T>
HWY_INLINE Pair<T> operator*(const Pair<T>& x, const Pair<T>& y) {
  return {x.a * y.a, x.b * y.b};
}
template <class T>
HWY_INLINE Pair<T> operator/(const Pair<T>& x, const Pair<T>& y) {
  return {x.a / y.a, x.b / y.b};
}
template <class T>
HWY_INLINE Pair<T> Fma(const Pair<T>& x, const Pair<T>& y, const Pair<T>& z) {
  return {Fma(x.a, y.a, z.a), Fma(x.b, y.b, z.b)};
}
template <class T>
HWY_INLINE Pair<T> Fnma(const Pair<T>& x, const Pair<T>& y, const Pair<T>& z) {
  return {Fnma(x.a, y.a, z.a), Fnma(x.b, y.b, z.b)};
}
template <class T>
HWY_INLINE Pair<T> Fms(const Pair<T>& x, const Pair<T>& y, const Pair<T>& z) {
  return {Fms(x.a, y.a, z.a), Fms(x.b, y.b, z.b)};
}
template <class T>
HWY_INLINE Pair<T> Fnms(const Pair<T>& x, const Pair<T>& y, const Pair<T>& z) {
  return {Fnms(x.a, y.a, z.a), Fnms(x.b, y.b, z.b)};
}
template <class T>
HWY_INLINE Pair<T> Sqrt(const Pair<T>& x) {
  return {Sqrt(x.a), Sqrt(x.b)};
}
template <class T>
HWY_INLINE Pair<T> Neg(const Pair<T>& x) {
  return {Neg(x.a), Neg(x.b)};
}
template <class T>
HWY_INLINE Pair<T> Min(const Pair<T>& x, const Pair<T>& y) {
  return {Min(x.a, y.a), Min(x.b, y.b)};
}
template <class T>
HWY_INLINE Pair<T> Max(const Pair<T>& x, const Pair<T>& y) {
  return {Max(x.a, y.a), Max(x.b, y.b)};
}
template <class T>
HWY_INLINE Pair<T> IfLessEqual(const Pair<T>& x, const Pair<T>& y, const Pair<T>& yes,
                               const Pair<T>& no) {
  return {IfLessEqual(x.a, y.a, yes.a, no.a), IfLessEqual(x.b, y.b, yes.b, no.b)};
}

template <class T>
HWY_INLINE bool AllLessEqual(const Pair<T>& x, const Pair<T>& y) {
  return AllLessEqual(x.a, y.a) && AllLessEqual(x.b, y.b);
}

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_PACK_INL_H_
