#include "core/analysis/reversals.h"

#include <algorithm>

namespace celt {

void Reversals::Take(double turns) {
  lowest = std::min(lowest, turns);
  highest = std::max(highest, turns);
  const bool up = turns - lowest >= kLeastTurns;
  const bool down = highest - turns >= kLeastTurns;
  if ((up && sense <= 0) || (down && sense >= 0)) {
    if (sense != 0) ++count;
    sense = sense == 0 ? (up ? 1 : -1) : -sense;
    lowest = highest = turns;
  }
}

}  // namespace celt
