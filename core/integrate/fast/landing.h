#pragma once

#include <array>

#include "absl/functional/function_ref.h"
#include "core/integrate/fast/verner9.h"

namespace celt::fast {

/// Where inside a step the orbit crosses the section: only to know how long to make the step that
/// lands there, so that a millionth of a step is accurate enough.

/// The stages whose rates, interpolated by a polynomial and integrated, give the state part-way
/// through a step.
inline constexpr std::array<int, 8> kInterpolated = {0, 9, 10, 8, 11, 12, 13, 14};

/// State part-way = state at the start + Σ weights[j] · (step length × rate at stage
/// kInterpolated[j]); `part` in [0, 1].
std::array<double, kInterpolated.size()> PartWeights(double part);

/// A value of the event function at a part of the step.
struct PartValue {
  double part;
  double value;
};

/// Where between `low` and `high`, of opposite signs, `value` vanishes, by inverse polynomial
/// interpolation on all values known; `other` is one more of them. Calls `value` two or three times
/// as a rule.
double FindCrossing(PartValue low, PartValue high, PartValue other,
                    absl::FunctionRef<double(double)> value);

}  // namespace celt::fast
