#include "core/analysis/cycle_search.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "core/analysis/random.h"

namespace celt {
namespace {

using Points = std::vector<Point>;

/// Whether b is a, started anywhere.
bool SameCycle(const Map& map, const Points& a, const Points& b, double distance) {
  const std::size_t period = a.size();
  for (std::size_t shift = 0; shift < period; ++shift) {
    std::size_t i = 0;
    while (i < period && map.Difference(a[i], b[(i + shift) % period]).norm() < distance) ++i;
    if (i == period) return true;
  }
  return false;
}

/// The image of a cycle; for a symmetry that reverses time it is passed through backwards.
Points ImageOf(const Symmetry& symmetry, const Points& points) {
  Points image;
  std::transform(points.begin(), points.end(), std::back_inserter(image), symmetry.apply);
  if (symmetry.reverses_time) std::reverse(image.begin(), image.end());
  return image;
}

/// A cycle and its images under the symmetries that reverse time, or under those that do not (then
/// with the cycle itself).
std::vector<Points> Images(const Map& map, const Points& points, bool reversed) {
  std::vector<Points> images;
  if (!reversed) images.push_back(points);
  for (const Symmetry& symmetry : map.Symmetries()) {
    if (symmetry.reverses_time == reversed) images.push_back(ImageOf(symmetry, points));
  }
  return images;
}

bool AnySame(const Map& map, const std::vector<Points>& images, const Points& points,
             double distance) {
  return std::any_of(images.begin(), images.end(), [&](const Points& image) {
    return image.size() == points.size() && SameCycle(map, image, points, distance);
  });
}

bool Less(const Point& a, const Point& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// Of a cycle and its twins the one with the least point, started there.
Points Representative(const Map& map, const Points& points) {
  Points best;
  for (Points& image : Images(map, points, /*reversed=*/false)) {
    std::rotate(image.begin(), std::min_element(image.begin(), image.end(), Less), image.end());
    if (best.empty() || Less(image.front(), best.front())) best = std::move(image);
  }
  return best;
}

int CountTwins(const Map& map, const Points& points, double distance) {
  std::vector<Points> different = {points};
  for (const Points& image : Images(map, points, /*reversed=*/false)) {
    if (!AnySame(map, different, image, distance)) different.push_back(image);
  }
  return static_cast<int>(different.size()) - 1;
}

FoundCycle Found(const Map& map, const CycleSearchOptions& options, CycleReport report) {
  FoundCycle found;
  report.points = Representative(map, report.points);
  found.twins = CountTwins(map, report.points, options.same_distance);
  found.cycle = std::move(report);
  return found;
}

/// Adds a cycle, or its hits to one that is known already.
void Add(const Map& map, double distance, const FoundCycle& found, CycleSearchState& state) {
  const auto images = Images(map, found.cycle.points, /*reversed=*/false);
  for (FoundCycle& known : state.cycles) {
    if (!AnySame(map, images, known.cycle.points, distance)) continue;
    known.hits += found.hits;
    return;
  }
  state.cycles.push_back(found);
}

/// The count that a search from one start belongs to.
std::int64_t& CountFor(const CycleReport& report, CycleSearchTally& tally) {
  switch (report.termination) {
    case CycleTermination::kConverged:
      return report.minimal_period < std::ssize(report.points) ? tally.shorter : tally.found;
    case CycleTermination::kLeftDomain:
      return tally.left_domain;
    case CycleTermination::kSingular:
      return tally.singular;
    case CycleTermination::kNoConvergence:
      break;
  }
  return tally.no_convergence;
}

void SearchFrom(const Map& map, const CycleSearchOptions& options, std::int64_t index,
                CycleSearchState& state) {
  ++state.tally.starts;
  auto report = FindCycle(map, DrawStart(options, index), options.period, options.newton);
  if (!report.ok()) {
    ++state.tally.outside;
    return;
  }
  ++CountFor(*report, state.tally);
  if (!report->converged() || report->minimal_period < options.period) return;
  FoundCycle found = Found(map, options, *std::move(report));
  found.first_start = index;
  found.hits = 1;
  Add(map, options.same_distance, found, state);
}

absl::Status CheckCorner(const Map& map, const char* name, const Point& corner) {
  if (corner.size() == map.dimension() && corner.allFinite()) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(name, ": must be ", map.dimension(), " finite numbers"));
}

}  // namespace

Point DrawStart(const CycleSearchOptions& options, std::int64_t index) {
  Uniform uniform(options.seed, static_cast<std::uint64_t>(index));
  Point start = options.lower;
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    start[i] += (options.upper[i] - options.lower[i]) * (uniform() + 1) / 2;
  }
  return start;
}

absl::Status CheckCycleSearch(const Map& map, const CycleSearchOptions& options) {
  if (options.period < 1 || options.period > kLongestPeriod) {
    return absl::InvalidArgumentError(absl::StrCat(
        "period: ", options.period, " is not allowed; it lies in [1, ", kLongestPeriod, "]"));
  }
  if (absl::Status status = CheckCorner(map, "lower", options.lower); !status.ok()) return status;
  if (absl::Status status = CheckCorner(map, "upper", options.upper); !status.ok()) return status;
  for (Eigen::Index i = 0; i < options.lower.size(); ++i) {
    if (options.lower[i] <= options.upper[i]) continue;
    return absl::InvalidArgumentError(absl::StrCat("upper: coordinate ", i + 1, " is ",
                                                   options.upper[i], ", below the ",
                                                   options.lower[i], " of lower"));
  }
  if (!(options.same_distance > 0 && options.same_distance <= 1)) {
    return absl::InvalidArgumentError(absl::StrCat("same_distance: ", options.same_distance,
                                                   " is not allowed; it lies in (0, 1]"));
  }
  return CheckNewton(options.newton);
}

absl::StatusOr<CycleSearchState> SearchCycles(const Map& map, const CycleSearchOptions& options,
                                              std::int64_t first, std::int64_t last,
                                              SearchTick tick) {
  if (absl::Status status = CheckCycleSearch(map, options); !status.ok()) return status;
  CycleSearchState state;
  for (std::int64_t index = first; index < last; ++index) {
    SearchFrom(map, options, index, state);
    if (!tick()) return absl::CancelledError("stopped before the search was done");
  }
  return state;
}

void Merge(const Map& map, const CycleSearchOptions& options, const CycleSearchState& later,
           CycleSearchState& state) {
  for (const FoundCycle& found : later.cycles) Add(map, options.same_distance, found, state);
  CycleSearchTally& tally = state.tally;
  tally.starts += later.tally.starts;
  tally.found += later.tally.found;
  tally.shorter += later.tally.shorter;
  tally.no_convergence += later.tally.no_convergence;
  tally.left_domain += later.tally.left_domain;
  tally.singular += later.tally.singular;
  tally.outside += later.tally.outside;
}

std::vector<int> MirrorIndices(const Map& map, const CycleSearchOptions& options,
                               const std::vector<FoundCycle>& cycles) {
  std::vector<int> mirrors;
  for (const FoundCycle& found : cycles) {
    const auto images = Images(map, found.cycle.points, /*reversed=*/true);
    const auto mirror = std::find_if(cycles.begin(), cycles.end(), [&](const FoundCycle& other) {
      return AnySame(map, images, other.cycle.points, options.same_distance);
    });
    mirrors.push_back(
        mirror == cycles.end() ? -1 : static_cast<int>(std::distance(cycles.begin(), mirror)));
  }
  return mirrors;
}

void AddMirrors(const Map& map, const CycleSearchOptions& options, CycleSearchState& state) {
  const std::vector<int> mirrors = MirrorIndices(map, options, state.cycles);
  for (std::size_t i = 0; i < mirrors.size(); ++i) {
    const auto images = Images(map, state.cycles[i].cycle.points, /*reversed=*/true);
    if (mirrors[i] >= 0 || images.empty()) continue;
    auto report = FindCycle(map, images.front(), options.newton);
    if (!report.ok() || !report->converged()) continue;
    FoundCycle found = Found(map, options, *std::move(report));
    found.first_start = -1;
    Add(map, options.same_distance, found, state);
  }
}

}  // namespace celt
