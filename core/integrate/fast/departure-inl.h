// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// The first of a way: from a task's (M, γ) to (ω, q), for all lanes of a group that begin one.
#if defined(CELT_FAST_DEPARTURE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_DEPARTURE_INL_H_
#undef CELT_FAST_DEPARTURE_INL_H_
#else
#define CELT_FAST_DEPARTURE_INL_H_
#endif

#include <algorithm>

#include "core/integrate/crossing.h"
#include "core/integrate/fast/momentum_chart-inl.h"
#include "core/integrate/fast/runge_kutta-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

/// Tasks of the lanes that begin a way, in (M/m, γ).
template <class Layout>
class Departures {
 public:
  bool any() const { return any_; }

  void Add(const CrossingTask& task, double mass, int lane) {
    any_ = true;
    begins_[lane] = 1;
    for (int i = 0; i < kChartSize; ++i) {
      const double scale = i < 3 ? 1 / mass : 1;
      state_[i * kN + lane] = scale * task.state[i];
      for (int j = 0; j < 3 && Layout::kTangents > 0; ++j) {
        tangents_[Layout::TangentAt(kChartSize, lane, j, i)] = scale * task.tangents(i, j);
      }
    }
  }

  /// Puts them where their lanes start, and forgets them.
  HWY_NOINLINE void Start(const StoneConstants& constants, States<Layout>& start) {
    using V = typename Layout::Orbit;
    using T = typename Layout::Tangent;
    V state[kChartSize];
    for (int i = 0; i < kChartSize; ++i) state[i] = Load<V>(state_ + i * kN);
    const VelocityChart<V> chart(constants, state);
    const V begins = Load<V>(begins_);
    for (int i = 0; i < kComponents; ++i) Replace(begins, chart.x[i], start.values + i * kN);
    for (int j = 0; j < Layout::kTangents; ++j) {
      T v[kChartSize], pushed[kComponents];
      for (int i = 0; i < kChartSize; ++i) {
        v[i] = Load<T>(tangents_ + (j * kChartSize + i) * kLanes<T>);
      }
      chart.Push(v, pushed);
      double* const out = start.values + Layout::kTangentStart + j * kComponents * kLanes<T>;
      for (int i = 0; i < kComponents; ++i) {
        Replace(Spread<T>(begins), pushed[i], out + i * kLanes<T>);
      }
    }
    any_ = false;
    std::fill_n(begins_, kN, 0);
  }

 private:
  static constexpr int kN = Layout::kOrbits;

  template <class V>
  static HWY_INLINE void Replace(V where, V value, double* at) {
    Store(IfLessEqual(Set<V>(1), where, value, Load<V>(at)), at);
  }

  bool any_ = false;
  HWY_ALIGN double begins_[kN] = {};  ///< 1 where a lane begins, else 0
  HWY_ALIGN double state_[kChartSize * kN] = {};
  HWY_ALIGN double tangents_[std::max(1, kChartSize* Layout::kTangents* Layout::kTangentLanes)] =
      {};
};

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_DEPARTURE_INL_H_
