#include "core/integrate/fast/lanes.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"

namespace celt::fast {

double StepFactor(double square_ratio) {
  constexpr double kAim = 0.917;  // (1/2)^(1/8)
  constexpr double kLeast = 0.2;
  constexpr double kMost = 2;
  if (!(square_ratio < 1e20)) return kLeast;
  // Roots and nothing else: the same on every machine.
  const double factor =
      kAim / std::sqrt(std::sqrt(std::sqrt(std::sqrt(std::max(square_ratio, 1e-20)))));
  return std::clamp(factor, kLeast, kMost);
}

absl::Status LostOrbit(const StoneState& state, double time, absl::string_view why) {
  return absl::OutOfRangeError(absl::StrCat("orbit lost at t = ", time, ", (M, gamma) = (",
                                            absl::StrJoin(state, ", "), "): ", why));
}

}  // namespace celt::fast
