#pragma once

#include <algorithm>
#include <cmath>

#include "absl/functional/function_ref.h"
#include "absl/status/statusor.h"

namespace celt {

/// An interval at whose ends a function has opposite signs, `best` the end with the smaller value.
struct ZeroBracket {
  double a = 0, b = 0;
  double value_a = 0, value_b = 0;
  double best() const { return std::abs(value_a) < std::abs(value_b) ? a : b; }
};

/// Shrinks a bracket of a continuous function's zero to `tolerance`, or to a zero itself
/// (Chandrupatla 1997): inverse quadratic interpolation where it is safe, else bisection; never
/// more evaluations than about thrice bisection. An evaluation that fails ends it with the bracket
/// as it was, and `complete` false.
struct ZeroResult {
  ZeroBracket bracket;
  bool complete = false;
};
ZeroResult FindZero(absl::FunctionRef<absl::StatusOr<double>(double)> function, ZeroBracket bracket,
                    double tolerance);

}  // namespace celt
