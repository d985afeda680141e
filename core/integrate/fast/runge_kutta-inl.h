// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// One step of the method for a group of lanes, each with its own step length. Tangents are advanced
// in the same stages as their orbit; the error estimate looks at the orbit alone.
#if defined(CELT_FAST_RUNGE_KUTTA_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_RUNGE_KUTTA_INL_H_
#undef CELT_FAST_RUNGE_KUTTA_INL_H_
#else
#define CELT_FAST_RUNGE_KUTTA_INL_H_
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "core/integrate/fast/pack-inl.h"
#include "core/integrate/fast/stone_rate-inl.h"
#include "core/integrate/fast/two_step.h"
#include "core/integrate/fast/verner9.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

/// How a group of orbits lies in vectors. A state is five components of the orbit, then those of
/// the tangents; each component holds a number for every orbit. With many orbits there are three
/// tangent vectors after each other; a single orbit has its three side by side in the lanes of one.
template <class OrbitVector, class TangentVector, int kTangentVectors>
struct Layout {
  using Orbit = OrbitVector;
  using Tangent = TangentVector;
  static constexpr int kTangents = kTangentVectors;
  static constexpr bool kAlike = std::is_same_v<Orbit, Tangent>;
  static constexpr int kOrbits = kLanes<Orbit>;
  static constexpr int kTangentLanes = kLanes<Tangent>;
  static constexpr int kOrbitSize = kComponents * kOrbits;
  /// Where tangents begin: a multiple of their vectors' length.
  static constexpr int kTangentStart =
      (kOrbitSize + kTangentLanes - 1) / kTangentLanes * kTangentLanes;
  static constexpr int kSize = kTangentStart + kTangents * kComponents * kTangentLanes;

  /// Where among tangents of `size` components one's is.
  static constexpr int TangentAt(int size, int lane, int tangent, int component) {
    return kAlike ? (tangent * size + component) * kOrbits + lane
                  : component * kTangentLanes + tangent;
  }
};

/// The states of a group with their times, or their rates with those of time.
template <class Layout>
struct States {
  HWY_ALIGN double values[Layout::kSize];
  HWY_ALIGN double time[Layout::kOrbits];
};

/// What a step leaves but for the new states: the error estimate, the orbit half-way, the stages.
template <class Layout>
struct StepResult {
  HWY_ALIGN double error[Layout::kOrbitSize];
  HWY_ALIGN double middle[Layout::kOrbitSize];
  States<Layout> stages[kStages];
};

/// The stage whose state is taken as the orbit half-way: c = 0.48375.
inline constexpr int kMiddleStage = 8;

/// A row of the method's table.
struct Row {
  const Coefficient* first;
  const Coefficient* last;
  const Coefficient* begin() const { return first; }
  const Coefficient* end() const { return last; }
};

/// Row of stage i; then the solution's and the error's.
HWY_INLINE Row RowAt(int i) { return {kCoefficients + kRow[i], kCoefficients + kRow[i + 1]}; }

/// What a stage's state is made of: rates of this step and of the one before.
struct StageRows {
  Row now;
  Row before;
};

template <std::size_t kNow, std::size_t kBefore>
HWY_INLINE StageRows RowsOf(const TwoStepRow<kNow, kBefore>& row) {
  return {{row.now.data(), row.now.data() + kNow},
          {row.before.data(), row.before.data() + kBefore}};
}

HWY_INLINE StageRows RowsAt(int stage, bool two_step) {
  if (two_step) {
    if (stage == kEarlyStage) return RowsOf(kEarlyRow);
    if (stage == 5) return RowsOf(kFifthRow);
    if (stage == 6) return RowsOf(kSixthRow);
  }
  return {RowAt(stage), {nullptr, nullptr}};
}

/// sum[i] += Σ coefficient · stage for `kCount` vectors of components. The more at once, the less a
/// sum waits for itself, as far as registers go.
template <class Layout, int kCount, class V>
HWY_INLINE void Add(Row row, const double* HWY_RESTRICT stages, V* HWY_RESTRICT sum) {
  constexpr int kStride = static_cast<int>(sizeof(States<Layout>) / sizeof(double));
  for (const Coefficient* c = row.first; c != row.last; ++c) {
    const V factor = Set<V>(c->value);
    const double* HWY_RESTRICT stage = stages + c->stage * kStride;
#pragma GCC unroll 15
    for (int i = 0; i < kCount; ++i) sum[i] = Fma(factor, Load<V>(stage + i * kLanes<V>), sum[i]);
  }
}

/// The same from `base` on.
template <class Layout, int kCount, class V>
HWY_INLINE void Combine(Row row, const double* HWY_RESTRICT base, const double* HWY_RESTRICT stages,
                        V* HWY_RESTRICT sum) {
#pragma GCC unroll 15
  for (int i = 0; i < kCount; ++i) sum[i] = Load<V>(base + i * kLanes<V>);
  Add<Layout, kCount>(row, stages, sum);
}

template <class V>
HWY_INLINE void LoadAll(const double* HWY_RESTRICT from, V* HWY_RESTRICT v) {
#pragma GCC unroll 5
  for (int i = 0; i < kComponents; ++i) v[i] = Load<V>(from + i * kLanes<V>);
}

template <int kCount = kComponents, class V>
HWY_INLINE void StoreAll(const V* HWY_RESTRICT v, double* HWY_RESTRICT to) {
#pragma GCC unroll 15
  for (int i = 0; i < kCount; ++i) Store(v[i], to + i * kLanes<V>);
}

/// The sums of a row for all of a group.
template <class Layout>
HWY_INLINE void CombineAll(Row row, const States<Layout>& base, const States<Layout>* stages,
                           double* HWY_RESTRICT out) {
  typename Layout::Orbit x[kComponents];
  Combine<Layout, kComponents>(row, base.values, stages->values, x);
  StoreAll(x, out);
  if constexpr (Layout::kTangents > 0) {
    constexpr int kCount = Layout::kTangents * kComponents;
    typename Layout::Tangent v[kCount];
    Combine<Layout, kCount>(row, base.values + Layout::kTangentStart,
                            stages->values + Layout::kTangentStart, v);
    StoreAll<kCount>(v, out + Layout::kTangentStart);
  }
}

/// A stage: the state that its rows give, and the rate there. Returns the orbit's part of the state
/// in `x`.
template <class Layout>
HWY_INLINE void EvaluateStage(const StoneConstants& constants,
                              const Stride<typename Layout::Orbit>& stride, const StageRows& rows,
                              const States<Layout>& start, const States<Layout>* before,
                              States<Layout>* stages, int stage, typename Layout::Orbit* x) {
  using V = typename Layout::Orbit;
  using T = typename Layout::Tangent;
  double* HWY_RESTRICT const out = stages[stage].values;
  Combine<Layout, kComponents>(rows.now, start.values, stages->values, x);
  Add<Layout, kComponents>(rows.before, before->values, x);
  V rate[kComponents], time;
  constexpr bool kWithTangents = Layout::kTangents > 0;
  Linearization<V> linear;
  Rate<kWithTangents>(constants, stride, x, rate, time, linear);
  StoreAll(rate, out);
  Store(time, stages[stage].time);
  if constexpr (kWithTangents) {
    constexpr int kCount = Layout::kTangents * kComponents;
    constexpr int kStart = Layout::kTangentStart;
    T v[kCount], v_rates[kCount];
    Combine<Layout, kCount>(rows.now, start.values + kStart, stages->values + kStart, v);
    Add<Layout, kCount>(rows.before, before->values + kStart, v);
#pragma GCC unroll 3
    for (int j = 0; j < Layout::kTangents; ++j)
      TangentRate(linear, v + j * kComponents, v_rates + j * kComponents);
    StoreAll<kCount>(v_rates, out + kStart);
  }
}

/// `before`: the stages of the step before, when every lane's was as long as this one; else null.
template <class Layout>
HWY_NOINLINE void Step(const StoneConstants& constants,
                       const Stride<typename Layout::Orbit>& stride, const States<Layout>& start,
                       const States<Layout>* before, StepResult<Layout>& result,
                       States<Layout>& end) {
  using V = typename Layout::Orbit;
  States<Layout>* const stages = result.stages;
  const bool two_step = before != nullptr;
  if (!two_step) before = stages;  // and not made use of
  V x[kComponents];
  for (int stage = 0; stage < kStages; ++stage) {
    if (two_step && stage > kEarlyStage && stage < 5) continue;
    EvaluateStage(constants, stride, RowsAt(stage, two_step), start, before, stages, stage, x);
    if (stage == kMiddleStage) StoreAll(x, result.middle);
  }

  CombineAll(RowAt(kStages), start, stages, end.values);
  V time = Load<V>(start.time);
  for (const Coefficient& c : RowAt(kStages))
    time = Fma(Set<V>(c.value), Load<V>(stages[c.stage].time), time);
  Store(time, end.time);
  HWY_ALIGN static constexpr double kZero[Layout::kOrbitSize] = {};
  Combine<Layout, kComponents>(RowAt(kStages + 1), kZero, stages->values, x);
  StoreAll(x, result.error);
}

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_RUNGE_KUTTA_INL_H_
