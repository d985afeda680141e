// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// The last of a way: from a state next to the section onto it, for one orbit. Newton's method on
// time tells how far, and a step so short that its cube is rounding goes there; where that leaves
// more than rounding, Newton's method has one more touch.
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

/// e and its side at a state.
HWY_INLINE SectionPlace<double> PlaceAt(const Problem& problem, const FastState& x,
                                        double gravity) {
  One state[kComponents];
  Unpack(x, state);
  const SectionPlace<One> place = Locate(problem.constants, problem.event.cosine(),
                                         problem.event.sine(), Set<One>(gravity), state);
  return {hn::GetLane(place.value), hn::GetLane(place.side)};
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
    rest_ = Rest(ToMomentum(problem.stone, x, up()), here_);
  }

  /// Scaled time to the section, signed; not finite where the orbit runs along the section.
  double rest() const { return rest_; }

  /// The crossing, when the rest is short enough. `time` is that so far.
  Crossing Finish(const FastTangents& tangents, double time) const {
    Arrival end(*this, x_ + rest_ * here_.x + 0.5 * rest_ * rest_ * here_.Apply(here_.x));
    double rest = rest_;
    // What Newton's first touch left is the square of the rest; Euler's step is exact for it.
    if (const double left = Rest(end.chart, end.rate); std::abs(left) > kRounding) {
      end = Arrival(*this, end.x + left * end.rate.x);
      rest += left;
    }
    Crossing crossing;
    crossing.state = end.chart.state;
    crossing.velocity.noalias() = end.chart.derivative * (end.rate.x / end.rate.time);
    crossing.time = std::abs(time + 0.5 * rest * (here_.time + end.rate.time));
    if constexpr (kWithTangents) {
      FastTangents landed;
      for (int j = 0; j < 3; ++j) {
        const FastState v = tangents.col(j);
        const FastState rate = here_.Apply(v);
        landed.col(j) = v + 0.5 * rest * (rate + end.rate.Apply(v + rest * rate));
      }
      crossing.tangents.noalias() = end.chart.derivative * landed;
    }
    return crossing;
  }

 private:
  /// Scaled time, where steps are about 0.3, that moves the section's value by its rounding.
  static constexpr double kRounding = 1e-14;

  /// A state with all that is asked of it at the end.
  struct Arrival {
    HWY_INLINE Arrival(const Touchdown& owner, const FastState& at)
        : x(at),
          rate(owner.problem_, at, owner.gravity_),
          chart(ToMomentum(owner.problem_.stone, at, owner.up())) {}
    FastState x;
    LocalRate rate;
    Chart chart;
  };

  double up() const { return gravity_ > 0 ? 1 : -1; }

  /// Newton's step on time.
  double Rest(const Chart& chart, const LocalRate& rate) const {
    const double slope = problem_.event.Gradient(chart.state).dot(chart.derivative * rate.x);
    return -problem_.event.Value(chart.state) / slope;
  }

  const Problem& problem_;
  FastState x_;
  double gravity_;
  LocalRate here_;
  double rest_;
};

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_TOUCHDOWN_INL_H_
