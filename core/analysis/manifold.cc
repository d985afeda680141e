#include "core/analysis/manifold.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "absl/strings/str_cat.h"

namespace celt {
namespace {

constexpr double kFirstStep = 1e-2;
constexpr double kLeastStep = 1e-9;
constexpr double kLeastGap = 1e-13;  // of s: neighbours this close are the same start

absl::Status CheckPositive(const char* name, double value) {
  if (value > 0) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(name, ": ", value, " is not allowed; must be positive"));
}

absl::Status CheckOptions(const Map& map, int side, const ManifoldOptions& options) {
  absl::Status status = CheckPositive("length", options.length);
  status.Update(CheckPositive("most_spacing", options.most_spacing));
  status.Update(CheckPositive("most_turning", options.most_turning));
  status.Update(CheckPositive("most_turning_by_spacing", options.most_turning_by_spacing));
  status.Update(CheckPositive("least_spacing", options.least_spacing));
  status.Update(CheckPositive("linear_error", options.linear_error));
  status.Update(CheckPositive("most_points", static_cast<double>(options.most_points)));
  if (side != 1 && side != -1) {
    status.Update(absl::InvalidArgumentError(
        absl::StrCat("side: ", side, " is not allowed; must be 1 or -1")));
  }
  const bool scaled = options.scale.size() > 0;
  if (scaled && (options.scale.size() != map.dimension() || !(options.scale.minCoeff() > 0))) {
    status.Update(absl::InvalidArgumentError(absl::StrCat(
        "scale: must have ", map.dimension(), " positive entries, one for each coordinate")));
  }
  return status;
}

Point StartAt(const Saddle& saddle, const ManifoldSide& side, double s) {
  return saddle.point + side.side * side.step * std::pow(saddle.expansion, s) * saddle.tangent;
}

/// Differences in the units of lengths.
class Ruler {
 public:
  Ruler(const Map& map, const ManifoldOptions& options) : map_(map), scale_(options.scale) {}

  Point Difference(const Point& a, const Point& b) const {
    Point difference = map_.Difference(a, b);
    if (scale_.size() > 0) difference = difference.cwiseQuotient(scale_);
    return difference;
  }

 private:
  const Map& map_;
  const Point& scale_;
};

/// Marks the gaps [i, i + 1] that need a point.
std::vector<bool> GapsToFill(const Ruler& ruler, const ManifoldOptions& options,
                             const ManifoldSide& side) {
  const std::size_t gaps = side.points.size() - 1;
  std::vector<bool> fill(gaps);
  Point before;
  double length_before = 0;
  for (std::size_t i = 0; i < gaps; ++i) {
    const Point chord = ruler.Difference(side.points[i + 1], side.points[i]);
    const double length = chord.norm();
    if (length > options.most_spacing) fill[i] = true;
    if (i > 0 && length > 0 && length_before > 0) {
      const double cosine = chord.dot(before) / (length * length_before);
      const double turning = std::acos(std::clamp(cosine, -1.0, 1.0));
      const double longer = std::max(length, length_before);
      const bool sharp =
          turning > options.most_turning || turning * longer > options.most_turning_by_spacing;
      if (sharp && length > options.least_spacing) fill[i] = true;
      if (sharp && length_before > options.least_spacing) fill[i - 1] = true;
    }
    before = chord;
    length_before = length;
  }
  return fill;
}

/// Cuts the generation off at the first point that has no image.
void CutAt(std::size_t count, ManifoldSide& side) {
  side.s.resize(count);
  side.points.resize(count);
}

/// Puts points in the middle of marked gaps. False when there was nothing to do, or nothing that
/// could be done.
bool FillOnce(const Map& map, const Saddle& saddle, const ManifoldOptions& options,
              ManifoldSide& side) {
  if (side.points.size() < 2) return false;
  const std::vector<bool> fill = GapsToFill(Ruler(map, options), options, side);
  std::vector<double> s;
  std::vector<Point> starts;
  for (std::size_t i = 0; i < fill.size(); ++i) {
    if (!fill[i] || side.s[i + 1] - side.s[i] < 2 * kLeastGap) continue;
    s.push_back((side.s[i] + side.s[i + 1]) / 2);
    starts.push_back(StartAt(saddle, side, s.back()));
  }
  if (s.empty()) return false;
  const std::int64_t iterates = std::int64_t{saddle.iterates} * side.generation;
  const Images images = ApplyMany(map, starts, iterates, saddle.direction);
  std::vector<double> all_s;
  std::vector<Point> all_points;
  std::size_t next = 0;
  for (std::size_t i = 0; i < side.s.size(); ++i) {
    all_s.push_back(side.s[i]);
    all_points.push_back(side.points[i]);
    if (next < s.size() && i + 1 < side.s.size() && s[next] < side.s[i + 1]) {
      if (!images.statuses[next].ok()) {
        side.end = ManifoldEnd::kLost;
        side.message = std::string(images.statuses[next].message());
        break;
      }
      all_s.push_back(s[next]);
      all_points.push_back(images.points[next++]);
    }
  }
  side.s = std::move(all_s);
  side.points = std::move(all_points);
  return side.end == ManifoldEnd::kNotYet;
}

bool IsTorn(const Map& map, const ManifoldOptions& options, const ManifoldSide& side) {
  const Ruler ruler(map, options);
  for (std::size_t i = 0; i + 1 < side.points.size(); ++i) {
    const double gap = ruler.Difference(side.points[i + 1], side.points[i]).norm();
    if (gap > options.most_spacing) return true;
  }
  return false;
}

void Refine(const Map& map, const Saddle& saddle, const ManifoldOptions& options,
            ManifoldSide& side) {
  while (FillOnce(map, saddle, options, side)) {
    if (std::ssize(side.points) + side.written > options.most_points) {
      side.end = ManifoldEnd::kMostPoints;
      return;
    }
  }
  if (side.end == ManifoldEnd::kNotYet && IsTorn(map, options, side)) {
    side.end = ManifoldEnd::kTorn;
    side.message = "neighbouring points part however close they start";
  }
}

/// The next generation: images of this one, then refined.
void Grow(const Map& map, const Saddle& saddle, const ManifoldOptions& options,
          ManifoldSide& side) {
  if (side.generation >= options.most_generations) {
    side.end = ManifoldEnd::kMostGenerations;
    side.done = true;
    return;
  }
  Images images = ApplyMany(map, side.points, saddle.iterates, saddle.direction);
  ++side.generation;
  const auto lost = std::find_if(images.statuses.begin(), images.statuses.end(),
                                 [](const absl::Status& status) { return !status.ok(); });
  side.points = std::move(images.points);
  if (lost != images.statuses.end()) {
    CutAt(static_cast<std::size_t>(lost - images.statuses.begin()), side);
  }
  Refine(map, saddle, options, side);
  if (lost != images.statuses.end() && side.end == ManifoldEnd::kNotYet) {
    side.end = ManifoldEnd::kLost;
    side.message = std::string(lost->message());
  }
}

/// Visits the present generation, but for its last point: the next begins with it.
absl::Status Write(const Map& map, const ManifoldOptions& options, ManifoldSide& side,
                   ManifoldVisit visit) {
  const Ruler ruler(map, options);
  for (std::size_t i = 0; i + 1 < side.points.size(); ++i) {
    if (!visit({side.points[i], side.arc_length, side.generation})) {
      return absl::CancelledError("stopped before the manifold was done");
    }
    ++side.written;
    if (side.arc_length >= options.length) {
      side.end = ManifoldEnd::kLength;
      return absl::OkStatus();
    }
    side.arc_length += ruler.Difference(side.points[i + 1], side.points[i]).norm();
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<ManifoldSide> StartManifold(const Map& map, const Saddle& saddle, int side,
                                           const ManifoldOptions& options) {
  if (absl::Status status = CheckOptions(map, side, options); !status.ok()) return status;
  const Ruler ruler(map, options);
  ManifoldSide start;
  start.side = side;
  start.s = {0, 0.25, 0.5, 0.75, 1};
  const double unit = 1 / ruler.Difference(saddle.point + saddle.tangent, saddle.point).norm();
  for (start.step = kFirstStep * unit; start.step > kLeastStep * unit; start.step /= 2) {
    const Point end = StartAt(saddle, start, 1);
    const Images images =
        ApplyMany(map, {{StartAt(saddle, start, 0)}}, saddle.iterates, saddle.direction);
    if (!images.statuses.front().ok()) continue;
    const double deviation = ruler.Difference(images.points.front(), end).norm();
    const double length = ruler.Difference(end, saddle.point).norm();
    if (deviation > options.linear_error * length || length > options.most_spacing) continue;
    for (const double s : start.s) start.points.push_back(StartAt(saddle, start, s));
    start.arc_length = length / saddle.expansion;
    return start;
  }
  return absl::OutOfRangeError(
      absl::StrCat("the map is not linear to ", options.linear_error,
                   " however near the saddle: ask for less, or for a finer tolerance of the map"));
}

absl::Status AdvanceManifold(const Map& map, const Saddle& saddle, const ManifoldOptions& options,
                             ManifoldSide& side, ManifoldVisit visit) {
  ManifoldSide next = side;
  if (absl::Status status = Write(map, options, next, visit); !status.ok()) return status;
  if (next.end == ManifoldEnd::kNotYet) {
    Grow(map, saddle, options, next);
  } else {
    next.done = true;
  }
  side = std::move(next);
  return absl::OkStatus();
}

}  // namespace celt
