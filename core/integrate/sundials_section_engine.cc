#include "core/integrate/sundials_section_engine.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/string_view.h"

namespace celt {
namespace {

absl::Status Lost(std::span<const double> y, double time, absl::string_view why) {
  return absl::OutOfRangeError(absl::StrCat("orbit lost at t = ", time, ", (M, gamma) = (",
                                            absl::StrJoin(y.first(6), ", "), "): ", why));
}

std::vector<double> Pack(const CrossingTask& task, Derivative derivative) {
  std::vector<double> y(task.state.begin(), task.state.end());
  if (derivative == Derivative::kJacobian) {
    y.insert(y.end(), task.tangents.data(), task.tangents.data() + task.tangents.size());
  }
  return y;
}

/// Why a state is no state to go on from; empty when it is one.
absl::string_view Defect(std::span<const double> y) {
  if (!std::ranges::all_of(y, [](double value) { return std::isfinite(value); }))
    return "no longer finite";
  if (!(std::abs(y[5]) >= kLeastGamma3)) return "gamma3 goes to 0, the contact point to infinity";
  return "";
}

/// Where in (0, 1) the cubic with these values and slopes at 0 and 1 changes its sign from that at
/// 0, by bisection.
double CubicRoot(double value0, double slope0, double value1, double slope1) {
  const double c2 = 3 * (value1 - value0) - 2 * slope0 - slope1;
  const double c3 = 2 * (value0 - value1) + slope0 + slope1;
  double low = 0;
  double high = 1;
  constexpr int kHalvings = 30;  // far below the error of the cubic
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const double value = value0 + middle * (slope0 + middle * (c2 + middle * c3));
    (value > 0) == (value0 > 0) ? low = middle : high = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

/// A way covered so far, and what is left of it.
struct SundialsSectionEngine::Leg {
  std::vector<double> y;
  double time = 0;
  double rest = 0;  ///< estimate of the time from here to the section
  double stride =
      0;  ///< length of the step that went across: the scale on which the solution changes
};

SundialsSectionEngine::SundialsSectionEngine(const CelticStone& stone, const SectionEvent& section,
                                             SteppingMethod method, double tolerance,
                                             const CrossingLimits& limits)
    : stone_(stone),
      event_(section),
      method_(method),
      tolerance_(tolerance),
      longest_time_(limits.longest_time * 2 * std::numbers::pi *
                    std::sqrt(std::max(stone.parameters().radius1, stone.parameters().radius2) /
                              stone.parameters().gravity)),
      most_steps_(limits.most_steps) {}

void SundialsSectionEngine::Run(CrossingFeed& feed, Direction direction,
                                Derivative derivative) const {
  CrossingTask task;
  int ticket = 0;
  while (feed.Next(task, ticket)) {
    const auto crossing = Cross(task, direction, derivative);
    feed.Done(ticket, crossing.status(), crossing.ok() ? *crossing : Crossing());
  }
}

absl::StatusOr<Crossing> SundialsSectionEngine::Cross(const CrossingTask& task, Direction direction,
                                                      Derivative derivative) const {
  const StoneProblem problem(stone_, derivative, tolerance_);
  auto leg = FindLanding(problem, task, direction == Direction::kForward ? 1 : -1);
  if (!leg.ok()) return leg.status();

  Crossing crossing;
  crossing.state = StateOf(leg->y);
  crossing.velocity = stone_.Field(crossing.state);
  crossing.time = std::abs(leg->time);
  if (derivative == Derivative::kJacobian) crossing.tangents = TangentsOf(leg->y);
  return crossing;
}

absl::StatusOr<SundialsSectionEngine::Leg> SundialsSectionEngine::FindLanding(
    const OdeProblem& problem, const CrossingTask& task, double sign) const {
  const auto carried =
      problem.size() > task.state.size() ? Derivative::kJacobian : Derivative::kNone;
  Leg leg{.y = Pack(task, carried)};
  const auto stepper = MakeStepper(problem, leg.y);
  // The start lies on the section, where e is rounding; that the orbit leaves it the right way
  // counts as e > 0.
  double before = 1;
  for (int step = 0; step < most_steps_; ++step) {
    const absl::Status status = stepper->Step(sign * longest_time_);
    const std::span<const double> y = stepper->state();
    if (const auto defect = Defect(y); !defect.empty()) return Lost(y, stepper->time(), defect);
    if (!status.ok()) return Lost(y, stepper->time(), status.message());

    const StoneState state = StateOf(y);
    const double after = sign * event_.Value(state);
    // Near |L/G| = 1 a step may begin on one side and end on the other: the crossing decides.
    if (before < 0 && after >= 0 && (event_.Side(StateOf(leg.y)) > 0 || event_.Side(state) > 0)) {
      Leg landed = leg;
      landed.stride = stepper->time() - leg.time;
      landed.rest =
          landed.stride * CubicRoot(before, std::abs(landed.stride) * EventRate(StateOf(leg.y)),
                                    after, std::abs(landed.stride) * EventRate(state));
      if (absl::Status landing = Land(problem, landed); !landing.ok()) return landing;
      if (event_.Side(StateOf(landed.y)) > 0) return landed;
    }
    if (stepper->time() == sign * longest_time_)
      return Lost(y, stepper->time(), "no crossing within the longest time");
    before = after;
    std::ranges::copy(y, leg.y.begin());
    leg.time = stepper->time();
  }
  return Lost(leg.y, leg.time, absl::StrCat("no crossing within ", most_steps_, " steps"));
}

absl::Status SundialsSectionEngine::Land(const OdeProblem& problem, Leg& leg) const {
  // Below this part of a stride Euler's step is exact: its error is the square of it.
  constexpr double kTiny = 1e-8;
  constexpr int kMostPasses = 10;
  for (int pass = 0; std::abs(leg.rest) > kTiny * std::abs(leg.stride); ++pass) {
    if (pass == kMostPasses) return Lost(leg.y, leg.time, "touches the section, does not cross it");
    const auto stepper = MakeRungeKuttaStepper(problem, leg.y, leg.rest);
    while (stepper->time() != leg.rest) {
      if (const absl::Status status = stepper->Step(leg.rest); !status.ok()) {
        return Lost(leg.y, leg.time, status.message());
      }
    }
    std::ranges::copy(stepper->state(), leg.y.begin());
    leg.time += leg.rest;
    const StoneState state = StateOf(leg.y);
    leg.rest = -event_.Value(state) / EventRate(state);
  }
  std::vector<double> rate(leg.y.size());
  problem.Rate(leg.y, rate);
  std::ranges::transform(leg.y, rate, leg.y.begin(),
                         [&](double y, double f) { return y + leg.rest * f; });
  leg.time += leg.rest;
  return absl::OkStatus();
}

std::unique_ptr<OdeStepper> SundialsSectionEngine::MakeStepper(
    const OdeProblem& problem, std::span<const double> start) const {
  return method_ == SteppingMethod::kAdams ? MakeAdamsStepper(problem, start)
                                           : MakeRungeKuttaStepper(problem, start);
}

double SundialsSectionEngine::EventRate(const StoneState& state) const {
  return event_.Gradient(state).dot(stone_.Field(state));
}

}  // namespace celt
