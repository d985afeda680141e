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

/// The starts of points in the middle of marked gaps, as many as one call may compute.
std::vector<double> MiddlesToFill(const ManifoldSide& side, const std::vector<bool>& fill,
                                  std::int64_t most) {
  std::vector<double> s;
  for (std::size_t i = 0; i < fill.size() && std::ssize(s) < most; ++i) {
    if (!fill[i] || side.s[i + 1] - side.s[i] < 2 * kLeastGap) continue;
    s.push_back((side.s[i] + side.s[i + 1]) / 2);
  }
  return s;
}

/// Puts points where they belong by their starts. The side ends where one was lost.
void Insert(const std::vector<double>& s, const Images& images, ManifoldSide& side) {
  std::vector<double> all_s;
  std::vector<Point> all_points;
  std::size_t next = 0;
  for (std::size_t i = 0; i < side.s.size(); ++i) {
    all_s.push_back(side.s[i]);
    all_points.push_back(side.points[i]);
    if (next == s.size() || i + 1 == side.s.size() || s[next] >= side.s[i + 1]) continue;
    if (!images.statuses[next].ok()) {
      side.end = ManifoldEnd::kLost;
      side.message = std::string(images.statuses[next].message());
      break;
    }
    all_s.push_back(s[next]);
    all_points.push_back(images.points[next++]);
  }
  side.s = std::move(all_s);
  side.points = std::move(all_points);
}

/// Points that go to the map together, when each takes so many iterates.
std::int64_t PointsAtOnce(const ManifoldOptions& options, std::int64_t iterates) {
  constexpr std::int64_t kLeast = 16;  // lanes of an engine
  return std::max(options.most_iterates / std::max<std::int64_t>(iterates, 1), kLeast);
}

bool IsTorn(const Map& map, const ManifoldOptions& options, const ManifoldSide& side) {
  const Ruler ruler(map, options);
  for (std::size_t i = 0; i + 1 < side.points.size(); ++i) {
    const double gap = ruler.Difference(side.points[i + 1], side.points[i]).norm();
    if (gap > options.most_spacing) return true;
  }
  return false;
}

/// Puts points in the middle of gaps that are too wide or turn too much.
void Refine(const Map& map, const Saddle& saddle, const ManifoldOptions& options,
            ManifoldSide& side) {
  const std::int64_t iterates = std::int64_t{saddle.iterates} * side.generation;
  std::vector<double> s;
  if (side.points.size() > 1) {
    s = MiddlesToFill(side, GapsToFill(Ruler(map, options), options, side),
                      PointsAtOnce(options, iterates));
  }
  if (!s.empty()) {
    std::vector<Point> starts;
    starts.reserve(s.size());
    for (const double at : s) starts.push_back(StartAt(saddle, side, at));
    Insert(s, ApplyMany(map, starts, iterates, saddle.direction), side);
    if (std::ssize(side.points) + side.written > options.most_points) {
      side.end = ManifoldEnd::kMostPoints;
    }
  } else if (!side.message.empty()) {  // it was cut off
    side.end = ManifoldEnd::kLost;
  } else if (IsTorn(map, options, side)) {
    side.end = ManifoldEnd::kTorn;
    side.message = "neighbouring points part however close they start";
  }
  side.refining = !s.empty() && side.end == ManifoldEnd::kNotYet;
}

/// The images of the next points; of all, they are the next generation, cut off at the first point
/// that has none.
void Grow(const Map& map, const Saddle& saddle, const ManifoldOptions& options,
          ManifoldSide& side) {
  if (side.generation >= options.most_generations) {
    side.end = ManifoldEnd::kMostGenerations;
    return;
  }
  const auto from = side.points.begin() + std::ssize(side.images);
  const std::int64_t count =
      std::min(side.points.end() - from, PointsAtOnce(options, saddle.iterates));
  const Images next =
      ApplyMany(map, std::span(from, from + count), saddle.iterates, saddle.direction);
  bool lost = false;
  for (std::size_t i = 0; i < next.points.size() && !lost; ++i) {
    lost = !next.statuses[i].ok();
    if (lost) side.message = std::string(next.statuses[i].message());
    if (!lost) side.images.push_back(next.points[i]);
  }
  if (!lost && side.images.size() < side.points.size()) return;
  side.s.resize(side.images.size());
  side.points = std::exchange(side.images, {});
  side.visited = 0;
  side.refining = true;
  ++side.generation;
}

/// Visits the next points of the present generation, but for its last: the next begins with it.
absl::Status Write(const Map& map, const ManifoldOptions& options, ManifoldSide& side,
                   ManifoldVisit visit) {
  const Ruler ruler(map, options);
  const std::int64_t last = std::ssize(side.points) - 1;
  const std::int64_t end = std::min(last, side.visited + options.most_visits);
  double arc_length = side.arc_length;
  std::int64_t i = side.visited;
  for (; i < end && arc_length < options.length; ++i) {
    if (!visit({side.points[i], arc_length, side.generation})) {
      return absl::CancelledError("stopped before the manifold was done");
    }
    arc_length += ruler.Difference(side.points[i + 1], side.points[i]).norm();
  }
  // The first point beyond the length is the last.
  const bool reached = i < last && arc_length >= options.length;
  if (reached && !visit({side.points[i], arc_length, side.generation})) {
    return absl::CancelledError("stopped before the manifold was done");
  }
  if (reached) side.end = ManifoldEnd::kLength;
  side.done = reached;
  side.written += i + (reached ? 1 : 0) - side.visited;
  side.visited = i;
  side.arc_length = arc_length;
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
  if (side.refining) {
    Refine(map, saddle, options, side);
  } else if (side.visited + 1 < std::ssize(side.points)) {
    return Write(map, options, side, visit);
  } else if (side.end == ManifoldEnd::kNotYet) {
    Grow(map, saddle, options, side);
  } else {
    side.done = true;
  }
  return absl::OkStatus();
}

}  // namespace celt
