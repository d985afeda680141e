#pragma once

#include "absl/status/status.h"
#include "absl/strings/string_view.h"
#include "core/integrate/fast/stone_constants.h"
#include "core/integrate/section_event.h"
#include "core/model/celtic_stone.h"

namespace celt::fast {

/// All that the lanes need to know, whatever they carry.
struct Problem {
  CelticStone stone;
  SectionEvent event;
  StoneConstants constants;
  double tolerance = 0;     ///< what the error estimate of a step may be
  double longest_step = 0;  ///< in scaled time
  double longest_time = 0;
  int most_steps = 0;
};

/// What to multiply a step by, given the square of its error over the allowed one: aims at half the
/// allowed error, as (1/2 · allowed/error)^(1/8), within [1/5, 2]. NaN gives 1/5.
double StepFactor(double square_ratio);
/// Up to here, StepFactor is not less than 1.
inline constexpr double kCalm = 0.24;

/// OUT_OF_RANGE, with the time and the state in the message.
absl::Status LostOrbit(const StoneState& state, double time, absl::string_view why);

}  // namespace celt::fast
