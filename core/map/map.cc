#include "core/map/map.h"

#include <cmath>

#include "absl/strings/str_cat.h"

namespace celt {
namespace {

absl::Status AdvanceOne(const Map& map, int orbit, const Point& start, const Advance& advance,
                        Visit visit) {
  Point x = start;
  for (std::int64_t i = 0; i < advance.iterates; ++i) {
    const absl::StatusOr<Image> image = map.Apply(x, advance.direction, advance.derivative);
    if (!image.ok()) return image.status();
    if (!visit(orbit, *image)) break;
    x = image->point;
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status Map::CheckPoint(const Point& x) const {
  if (x.size() != dimension()) {
    return absl::InvalidArgumentError(absl::StrCat(
        "point: has ", x.size(), " coordinates, this map's points have ", dimension()));
  }
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (std::isfinite(x[i])) continue;
    return absl::InvalidArgumentError(
        absl::StrCat("coordinate ", i + 1, ": ", x[i], " is not a finite number"));
  }
  return absl::OkStatus();
}

std::vector<absl::Status> Map::AdvanceAll(std::span<const Point> starts, const Advance& advance,
                                          Visit visit) const {
  std::vector<absl::Status> statuses;
  statuses.reserve(starts.size());
  for (int orbit = 0; orbit < static_cast<int>(starts.size()); ++orbit) {
    statuses.push_back(AdvanceOne(*this, orbit, starts[orbit], advance, visit));
  }
  return statuses;
}

}  // namespace celt
