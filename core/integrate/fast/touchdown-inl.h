// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// The last of a way: from a state next to the section onto it, for one orbit. Newton's method on
// time tells how far, and a step so short that its cube is rounding goes there,
//
//     x + δ f + ½ δ² f'f,      v + ½ δ (f'(x) v + f'(x_end) (v + δ f'(x) v)).
#if defined(CELT_FAST_TOUCHDOWN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_TOUCHDOWN_INL_H_
#undef CELT_FAST_TOUCHDOWN_INL_H_
#else
#define CELT_FAST_TOUCHDOWN_INL_H_
#endif

#include <cmath>

#include "core/integrate/crossing.h"
#include "core/integrate/fast/coordinates.h"
#include "core/integrate/fast/lanes.h"
#include "core/integrate/fast/section_value-inl.h"
#include "core/integrate/fast/stone_rate-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

using One = Lanes<1>;

HWY_INLINE void Unpack(const FastState& x, One* HWY_RESTRICT out) {
  for (int i = 0; i < kComponents; ++i) out[i] = Set<One>(x[i]);
}

HWY_INLINE FastState Repack(const One* HWY_RESTRICT x) {
  FastState out;
  for (int i = 0; i < kComponents; ++i) out[i] = hn::GetLane(x[i]);
  return out;
}

/// e at a state.
HWY_INLINE double ValueAt(const Problem& problem, const FastState& x, double gravity) {
  One state[kComponents];
  Unpack(x, state);
  return hn::GetLane(
      Locate(problem.constants, problem.cosine, problem.sine, Set<One>(gravity), state).value);
}

/// The rate at a state, per unit of scaled time, and its derivative there.
struct LocalRate {
  HWY_INLINE LocalRate(const Problem& problem, const FastState& at, double gravity) {
    One state[kComponents], rate[kComponents], scale;
    Unpack(at, state);
    const Stride<One> unit{Set<One>(1), Set<One>(1), Set<One>(gravity)};
    Rate<true>(problem.constants, unit, state, rate, scale, linear);
    x = Repack(rate);
    time = hn::GetLane(scale);
  }

  HWY_INLINE FastState Apply(const FastState& v) const {
    One in[kComponents], out[kComponents];
    Unpack(v, in);
    TangentRate(linear, in, out);
    return Repack(out);
  }

  FastState x;
  double time;
  Linearization<One> linear;
};

template <bool kWithTangents>
class Touchdown {
 public:
  Touchdown(const Problem& problem, const FastState& x, double gravity)
      : problem_(problem), x_(x), gravity_(gravity), here_(problem, x, gravity) {
    const Chart chart = ToMomentum(problem.stone, x, up());
    const double slope = problem.event.Gradient(chart.state).dot(chart.derivative * here_.x);
    rest_ = -problem.event.Value(chart.state) / slope;
  }

  /// Scaled time to the section, signed; not finite where the orbit runs along the section.
  double rest() const { return rest_; }

  /// The crossing, when the rest is short enough. `time` is that so far.
  Crossing Finish(const FastTangents& tangents, double time) const {
    const FastState x = x_ + rest_ * here_.x + 0.5 * rest_ * rest_ * here_.Apply(here_.x);
    const LocalRate there(problem_, x, gravity_);
    const Chart chart = ToMomentum(problem_.stone, x, up());
    Crossing crossing;
    crossing.state = chart.state;
    crossing.velocity.noalias() = chart.derivative * (there.x / there.time);
    crossing.time = std::abs(time + 0.5 * rest_ * (here_.time + there.time));
    if constexpr (kWithTangents) {
      FastTangents landed;
      for (int j = 0; j < 3; ++j) {
        const FastState v = tangents.col(j);
        const FastState rate = here_.Apply(v);
        landed.col(j) = v + 0.5 * rest_ * (rate + there.Apply(v + rest_ * rate));
      }
      crossing.tangents.noalias() = chart.derivative * landed;
    }
    return crossing;
  }

 private:
  double up() const { return gravity_ > 0 ? 1 : -1; }

  const Problem& problem_;
  FastState x_;
  double gravity_;
  LocalRate here_;
  double rest_;
};

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_TOUCHDOWN_INL_H_
