#pragma once

#include <array>
#include <optional>

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

/// Where the orbit is at a part of the step.
struct Look {
  double part;
  double value;  ///< e of section_event.h, with the sign that makes a crossing one upward
  double side;   ///< positive next to the section, negative half a turn away from it
};

/// The part of the step at which the orbit crosses the section between `low` and `high`, if it
/// does. `other` is one more look at the step, `look` takes another.
std::optional<double> CrossingPart(const Look& low, const Look& high, const Look& other,
                                   absl::FunctionRef<Look(double)> look);

}  // namespace celt::fast
