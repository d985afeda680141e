// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// The last of a way: from a state next to the section onto it, for all lanes of a group. Newton's
// method on time tells how far, and a step so short that its cube is rounding goes there; what that
// leaves is the square of it, for which one more touch of Newton's method, by Euler's step, is
// exact.
//
//     x + δ f + ½ δ² f'f,      v + ½ δ (f'(x) v + f'(x_end) (v + δ f'(x) v)).
#if defined(CELT_FAST_TOUCHDOWN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_TOUCHDOWN_INL_H_
#undef CELT_FAST_TOUCHDOWN_INL_H_
#else
#define CELT_FAST_TOUCHDOWN_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "core/integrate/crossing.h"
#include "core/integrate/fast/lanes.h"
#include "core/integrate/fast/momentum_chart-inl.h"
#include "core/integrate/fast/runge_kutta-inl.h"
#include "core/integrate/fast/stone_rate-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

/// A state, the rate there per unit of scaled time with its derivative, and (M/m, γ).
template <class V>
struct Arrival {
  HWY_INLINE Arrival(const Problem& problem, V gravity, const V* HWY_RESTRICT at)
      : chart(problem.constants, IfLessEqual(Set<V>(0), gravity, Set<V>(1), Set<V>(-1)), at) {
    for (int i = 0; i < kComponents; ++i) x[i] = at[i];
    const Stride<V> unit{Set<V>(1), Set<V>(1), gravity};
    Rate<true>(problem.constants, unit, x, rate, time, linear);
    chart.Push(rate, velocity);
    rest = TimeToSection(problem.event.cosine(), problem.event.sine());
  }

  /// Newton's step on time, e/ė with e of section_event.h: scaled time to the section, signed; not
  /// finite where the orbit runs along the section.
  HWY_INLINE V TimeToSection(double cosine, double sine) const {
    const V *m = chart.state, *gamma = chart.state + 3;
    const V *dm = velocity, *dgamma = velocity + 3;
    const auto dot = [](const V* a, const V* b)
                         HWY_ATTR { return Fma(a[2], b[2], Fma(a[1], b[1], a[0] * b[0])); };
    const V over = Set<V>(1) / Sqrt(dot(m, m));  // 1/G
    const V size = dot(m, m) * over;
    const V l = m[2] * over, h = dot(m, gamma) * over;  // L/G, H/G
    const V dsize = dot(m, dm) * over;
    const V dh = dot(m, dgamma) + dot(dm, gamma);
    const V s = Fms(m[1], gamma[0], m[0] * gamma[1]);
    const V c = Fms(m[2], h, size * gamma[2]);
    const V ds = (Fms(dm[1], gamma[0], dm[0] * gamma[1])) + Fms(m[1], dgamma[0], m[0] * dgamma[1]);
    const V dc = Fnma(size, dgamma[2], Fnma(dsize, Fma(l, h, gamma[2]), Fma(l, dh, h * dm[2])));
    const V cos = Set<V>(cosine), sin = Set<V>(sine);
    return Neg(Fms(s, cos, c * sin) / Fms(ds, cos, dc * sin));
  }

  V x[kComponents];
  MomentumChart<V> chart;
  V rate[kComponents];
  V time;  ///< per unit of scaled time
  Linearization<V> linear;
  V velocity[kChartSize];  ///< of (M/m, γ) per unit of scaled time
  V rest;
};

/// Where the lanes arrive, in (M/m, γ).
template <class Layout>
struct Arrivals {
  HWY_ALIGN double rest[Layout::kOrbits];  ///< scaled time there was to go
  HWY_ALIGN double time[Layout::kOrbits];
  HWY_ALIGN double state[kChartSize * Layout::kOrbits];
  HWY_ALIGN double velocity[kChartSize * Layout::kOrbits];
  HWY_ALIGN double tangents[std::max(1, kChartSize* Layout::kTangents* Layout::kTangentLanes)];

  /// That of a lane.
  Crossing At(double mass, int lane) const {
    Crossing crossing;
    crossing.time = std::abs(time[lane]);
    for (int i = 0; i < kChartSize; ++i) {
      const double scale = i < 3 ? mass : 1;
      crossing.state[i] = scale * state[i * Layout::kOrbits + lane];
      crossing.velocity[i] = scale * velocity[i * Layout::kOrbits + lane];
      for (int j = 0; j < 3 && Layout::kTangents > 0; ++j) {
        crossing.tangents(i, j) = scale * tangents[Layout::TangentAt(kChartSize, lane, j, i)];
      }
    }
    return crossing;
  }
};

/// Scaled time, where steps are about 0.3, that moves the section's value by its rounding.
inline constexpr double kRounding = 1e-14;

/// The arrival after Newton's second touch from `end`, and how far that went.
template <class V>
HWY_INLINE V Correct(const Problem& problem, V gravity, Arrival<V>& end) {
  const V zero = Set<V>(0);
  const V left = Max(end.rest, Neg(end.rest));
  const V correction = IfLessEqual(left, Set<V>(kRounding), zero, end.rest);
  HWY_ALIGN double parts[kLanes<V>];
  Store(correction, parts);
  // Where all are 0, the same would come out once more.
  if (std::any_of(parts, parts + kLanes<V>, [](double part) { return part != 0; })) {
    V x[kComponents];
    for (int i = 0; i < kComponents; ++i) x[i] = Fma(correction, end.rate[i], end.x[i]);
    end = Arrival<V>(problem, gravity, x);
  }
  return correction;
}

/// Onto the section from the ends of steps that left little.
template <class Layout>
HWY_NOINLINE void TouchDown(const Problem& problem, const double* gravities,
                            const States<Layout>& from, Arrivals<Layout>& out) {
  using V = typename Layout::Orbit;
  using T = typename Layout::Tangent;
  const V gravity = Load<V>(gravities), half = Set<V>(0.5);
  V x[kComponents], bend[kComponents];
  LoadAll(from.values, x);
  const Arrival<V> here(problem, gravity, x);
  Store(here.rest, out.rest);
  TangentRate(here.linear, here.rate, bend);
  for (int i = 0; i < kComponents; ++i) {
    x[i] = Fma(here.rest, Fma(half * here.rest, bend[i], here.rate[i]), x[i]);
  }
  Arrival<V> end(problem, gravity, x);
  const V rest = here.rest + Correct(problem, gravity, end);
  Store(Fma(half * rest, here.time + end.time, Load<V>(from.time)), out.time);
  for (int i = 0; i < kChartSize; ++i) {
    Store(end.chart.state[i], out.state + i * kLanes<V>);
    Store(end.velocity[i] / end.time, out.velocity + i * kLanes<V>);
  }
  const T step = Spread<T>(rest), half_step = Spread<T>(half * rest);
  for (int j = 0; j < Layout::kTangents; ++j) {
    T v[kComponents], first[kComponents], second[kComponents], pushed[kChartSize];
    LoadAll(from.values + Layout::kTangentStart + j * kComponents * kLanes<T>, v);
    TangentRate(here.linear, v, first);
    for (int i = 0; i < kComponents; ++i) second[i] = Fma(step, first[i], v[i]);
    T ahead[kComponents];
    TangentRate(end.linear, second, ahead);
    for (int i = 0; i < kComponents; ++i) v[i] = Fma(half_step, first[i] + ahead[i], v[i]);
    end.chart.Push(v, pushed);
    StoreAll<kChartSize>(pushed, out.tangents + j * kChartSize * kLanes<T>);
  }
}

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_TOUCHDOWN_INL_H_
