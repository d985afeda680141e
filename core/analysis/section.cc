#include "core/analysis/section.h"

namespace celt {

absl::Status AdvanceSection(const Map& map, SectionOrbit& orbit, std::int64_t iterates,
                            Direction direction, SectionVisit visit) {
  const int sign = direction == Direction::kForward ? 1 : -1;
  bool cancelled = false;
  const Point start = orbit.point;
  const Advance advance = {.iterates = iterates, .direction = direction};
  const auto statuses = map.AdvanceAll({&start, 1}, advance, [&](int, const Image& image) {
    orbit = {image.point, orbit.iterate + sign, orbit.time + sign * image.time};
    cancelled = !visit({orbit, image.time});
    return !cancelled;
  });
  if (!statuses.front().ok()) return statuses.front();
  return cancelled ? absl::CancelledError("stopped before the orbit was done") : absl::OkStatus();
}

}  // namespace celt
