// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// A way between two steps, in no lane, and how it gets out of one and into one.
#if defined(CELT_FAST_FLIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_FLIGHT_INL_H_
#undef CELT_FAST_FLIGHT_INL_H_
#else
#define CELT_FAST_FLIGHT_INL_H_
#endif

#include <array>

#include "core/integrate/fast/runge_kutta-inl.h"
#include "core/integrate/fast/two_step.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

/// A lane's numbers among the states of a group.
template <class Layout>
using Column = std::array<double, Layout::kSize / Layout::kOrbits>;

template <class Layout>
Column<Layout> ColumnOf(const States<Layout>& states, int lane) {
  Column<Layout> column;
  for (std::size_t i = 0; i < column.size(); ++i) {
    column[i] = states.values[i * Layout::kOrbits + lane];
  }
  return column;
}

template <class Layout>
void PutColumn(const Column<Layout>& column, States<Layout>& states, int lane) {
  for (std::size_t i = 0; i < column.size(); ++i) {
    states.values[i * Layout::kOrbits + lane] = column[i];
  }
}

template <class Layout>
struct Flight {
  bool landing = false;  ///< the step goes to the section
  int ticket = 0;
  int passes = 0;  ///< steps to the section so far
  double steps = 0;
  double time = 0;
  double length = 0;   ///< of the step to take
  double gravity = 0;  ///< g γ₃/|γ₃|
  double value = 0;    ///< of the event, and its side
  double side = 0;
  Column<Layout> state;
  /// Rates of the step before, where that is asked for.
  std::array<Column<Layout>, kHistory.size()> history;
};

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_FLIGHT_INL_H_
