#include "core/analysis/separatrix.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"

namespace celt {
namespace {

constexpr double kAway = 1000;    // times the first step
constexpr double kOnASide = 0.2;  // of the largest distance from the plane so far
constexpr int kWanderingChanges = 2;

using Tick = absl::FunctionRef<bool(std::int64_t)>;

absl::Status CheckOptions(const SeparatrixOptions& options) {
  if (options.side != 1 && options.side != -1) {
    return absl::InvalidArgumentError(
        absl::StrCat("side: ", options.side, " is not allowed; must be 1 or -1"));
  }
  if (!(options.step > 0) || !(options.tolerance > 0) || options.most_iterates < 1) {
    return absl::InvalidArgumentError(
        absl::StrCat("step: ", options.step, ", tolerance: ", options.tolerance,
                     ", most_iterates: ", options.most_iterates, "; all must be positive"));
  }
  return absl::OkStatus();
}

/// Watches an orbit of G.
class Watch {
 public:
  Watch(const Map& map, const Saddle& saddle, const SeparatrixOptions& options)
      : map_(map), saddle_(saddle), options_(options) {
    fate_.side = options.side;
    fate_.point = saddle.point + options.side * options.step * saddle.tangent;
  }

  /// Takes the next iterate; false when the fate is decided.
  bool Take(const Point& x) {
    const double moved = map_.Difference(x, fate_.point).norm();
    const Point offset = map_.Difference(x, saddle_.point);
    const double height = saddle_.normal.dot(offset);
    fate_.point = x;
    ++fate_.iterates;
    highest_ = std::max(highest_, std::abs(height));
    const int side = height > 0 ? 1 : -1;
    if (std::abs(height) > kOnASide * highest_ && side != fate_.side) {
      fate_.side = side;
      ++fate_.changes;
    }
    away_ = away_ || offset.norm() > kAway * options_.step;
    if (fate_.changes >= kWanderingChanges) fate_.end = SeparatrixEnd::kWanders;
    if (away_ && moved < options_.tolerance && offset.norm() > kAway * options_.step) {
      fate_.end = SeparatrixEnd::kTendsToCycle;
    }
    return fate_.end == SeparatrixEnd::kUndecided;
  }

  SeparatrixFate& fate() { return fate_; }

 private:
  const Map& map_;
  const Saddle& saddle_;
  SeparatrixOptions options_;
  SeparatrixFate fate_;
  double highest_ = 0;
  bool away_ = false;
};

bool Answer(SeparatrixQuestion question, const SeparatrixFate& fate) {
  return question == SeparatrixQuestion::kReturnsToItsSide
             ? fate.changes == 0
             : fate.end == SeparatrixEnd::kTendsToCycle;
}

absl::StatusOr<std::vector<Point>> FindSaddleCycle(const Map& map, const Point& guess,
                                                   const SeparatrixSearch& search, double value) {
  const auto report = FindCycle(map, guess, search.period);
  if (!report.ok()) return report.status();
  if (report->converged() && report->minimal_period == search.period) return report->points;
  const std::string reason =
      report->converged()
          ? absl::StrCat("one of period ", report->minimal_period, " gone round several times")
          : report->message;
  return absl::NotFoundError(absl::StrCat("no cycle of period ", search.period, " found at ", value,
                                          ": ", reason, "; residual ", report->residual, " after ",
                                          report->iterations, " iterations"));
}

absl::StatusOr<SeparatrixProbe> ProbeAt(const MapFamily& family, const SeparatrixSearch& search,
                                        const Point& guess, double value, Tick tick) {
  const auto map = family(value);
  if (!map.ok()) return map.status();
  const auto cycle = FindSaddleCycle(**map, guess, search, value);
  if (!cycle.ok()) return cycle.status();
  const auto saddle = MakeSaddle(**map, *cycle, Direction::kForward);
  if (!saddle.ok()) return saddle.status();
  auto fate = FollowSeparatrix(**map, *saddle, search.options, tick);
  if (!fate.ok()) return fate.status();
  const bool answer = Answer(search.question, *fate);
  return SeparatrixProbe{.value = value,
                         .saddle = saddle->point,
                         .iterates = saddle->iterates,
                         .fate = *std::move(fate),
                         .answer = answer};
}

absl::Status CheckEnds(const SeparatrixProbe& a, const SeparatrixProbe& b) {
  if (a.answer != b.answer) return absl::OkStatus();
  const auto tell = [](const SeparatrixProbe& probe) {
    return absl::StrCat(probe.value, " (", Name(probe.fate.end), ", ", probe.fate.changes,
                        " changes of side)");
  };
  return absl::InvalidArgumentError(
      absl::StrCat("from, to: the separatrix does the same at both ends, ", tell(a), " and ",
                   tell(b), "; they must differ"));
}

double Middle(const std::vector<SeparatrixProbe>& ends) {
  return ends[0].value + (ends[1].value - ends[0].value) / 2;
}

bool IsNarrow(const std::vector<SeparatrixProbe>& ends, double width) {
  if (std::abs(ends[1].value - ends[0].value) <= width) return true;
  const double middle = Middle(ends);
  return middle == ends[0].value || middle == ends[1].value;  // the doubles have run out
}

}  // namespace

absl::StatusOr<SeparatrixFate> FollowSeparatrix(const Map& map, const Saddle& saddle,
                                                const SeparatrixOptions& options, Tick tick) {
  if (absl::Status status = CheckOptions(options); !status.ok()) return status;
  Watch watch(map, saddle, options);
  const Point start = watch.fate().point;
  std::int64_t applied = 0;
  bool cancelled = false;
  const Advance advance = {.iterates = options.most_iterates * saddle.iterates,
                           .direction = saddle.direction};
  const auto statuses = map.AdvanceAll({&start, 1}, advance, [&](int, const Image& image) {
    if (++applied % saddle.iterates != 0) return true;
    cancelled = !tick(applied / saddle.iterates);
    return !cancelled && watch.Take(image.point);
  });
  if (cancelled) return absl::CancelledError("stopped before the separatrix was decided");
  SeparatrixFate& fate = watch.fate();
  if (const absl::Status& status = statuses.front(); !status.ok()) {
    fate.end = SeparatrixEnd::kLost;
    fate.message = std::string(status.message());
  }
  return fate;
}

absl::Status StepBisection(const MapFamily& family, const SeparatrixSearch& search,
                           SeparatrixBisection& bisection, Tick tick) {
  if (!(search.width > 0)) {
    return absl::InvalidArgumentError(
        absl::StrCat("width: ", search.width, " is not allowed; must be positive"));
  }
  std::vector<SeparatrixProbe>& ends = bisection.ends;
  const double value = ends.empty() ? search.from : ends.size() == 1 ? search.to : Middle(ends);
  const Point& guess = ends.empty() ? search.guess : ends[0].saddle;
  auto probe = ProbeAt(family, search, guess, value, tick);
  if (!probe.ok()) return probe.status();
  bisection.last = *std::move(probe);
  if (ends.size() < 2) {
    ends.push_back(bisection.last);
    if (ends.size() < 2) return absl::OkStatus();
    if (absl::Status status = CheckEnds(ends[0], ends[1]); !status.ok()) return status;
  } else {
    ends[bisection.last.answer == ends[0].answer ? 0 : 1] = bisection.last;
  }
  bisection.done = IsNarrow(ends, search.width);
  return absl::OkStatus();
}

SeparatrixBracket BracketOf(const SeparatrixBisection& bisection) {
  assert(bisection.ends.size() == 2);
  const bool first = bisection.ends[0].answer;
  const SeparatrixProbe& yes = bisection.ends[first ? 0 : 1];
  const SeparatrixProbe& no = bisection.ends[first ? 1 : 0];
  return {.yes = yes.value,
          .no = no.value,
          .saddle = bisection.last.saddle,
          .yes_fate = yes.fate,
          .no_fate = no.fate};
}

absl::StatusOr<SeparatrixBracket> BisectSeparatrix(const MapFamily& family,
                                                   const SeparatrixSearch& search, Tick tick) {
  SeparatrixBisection bisection;
  while (!bisection.done) {
    absl::Status status = StepBisection(family, search, bisection, tick);
    if (!status.ok()) return status;
  }
  return BracketOf(bisection);
}

const char* Name(SeparatrixEnd end) {
  switch (end) {
    case SeparatrixEnd::kTendsToCycle:
      return "tends to a cycle";
    case SeparatrixEnd::kWanders:
      return "wanders";
    case SeparatrixEnd::kLost:
      return "lost";
    case SeparatrixEnd::kUndecided:
      break;
  }
  return "undecided";
}

}  // namespace celt
