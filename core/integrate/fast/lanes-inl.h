// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// A group of lanes, each on its own way to its own crossing. Steps are taken together; everything
// else is each lane's own affair.
//
// One kind of group takes steps that know nothing of the step before, another such as make use of
// it (two_step.h). A way begins and ends in a group of the first kind and goes most of its steps in
// one of the second: see relay-inl.h.
//
// Steps are kLongestStep (lanes.h) long in scaled time unless the error estimate objects: the
// estimate, of an order less than the solution, swings over a factor of a thousand along an orbit
// whose error per step hardly changes, and control by it takes a fifth more steps for the same
// accuracy. Nearly all steps are then of the plain kind, that neither crosses nor is to change its
// length, and what they need is found out for all lanes at once.
#if defined(CELT_FAST_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_LANES_INL_H_
#undef CELT_FAST_LANES_INL_H_
#else
#define CELT_FAST_LANES_INL_H_
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "core/integrate/crossing.h"
#include "core/integrate/fast/coordinates.h"
#include "core/integrate/fast/departure-inl.h"
#include "core/integrate/fast/flight-inl.h"
#include "core/integrate/fast/landing.h"
#include "core/integrate/fast/lanes.h"
#include "core/integrate/fast/runge_kutta-inl.h"
#include "core/integrate/fast/section_value-inl.h"
#include "core/integrate/fast/touchdown-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

/// Whether steps make use of the step before.
enum class Memory { kNone, kStepBefore };

template <class Layout, Memory kMemory>
class Group {
 public:
  static constexpr int kN = Layout::kOrbits;

  Group(const Problem& problem, Direction direction)
      : problem_(problem),
        direction_(direction == Direction::kForward ? 1 : -1),
        sense_(direction_ * problem.event.sense()) {
    for (const int stage : kHistory) before_->stages[stage] = {};
    for (int lane = 0; lane < kN; ++lane) Park(lane);
  }

  /// Number of lanes at work.
  int busy() const { return busy_; }

  /// A task of the feed's into an idle lane. Whether there was one.
  bool Begin(CrossingFeed& feed) {
    CrossingTask task;
    int ticket = 0;
    if (!feed.Next(task, ticket)) return false;
    Begin(feed, IdleLane(), task, ticket);
    return true;
  }

  /// Takes a way into an idle lane. If steps make use of the step before, it has taken one as long
  /// as its next.
  void Put(const Flight<Layout>& flight) {
    const int lane = IdleLane();
    Lane& own = lanes_[lane];
    own = {.busy = true,
           .landing = flight.landing,
           .ticket = flight.ticket,
           .passes = flight.passes,
           .up = flight.gravity > 0 ? 1.0 : -1.0};
    ++busy_;
    steps_[lane] = flight.steps;
    start_->time[lane] = flight.time;
    length_[lane] = flight.length;
    gravity_[lane] = flight.gravity;
    start_value_[lane] = flight.value;
    start_side_[lane] = flight.side;
    PutColumn(flight.state, *start_, lane);
    if constexpr (kRemembers) {
      for (std::size_t i = 0; i < kHistory.size(); ++i) {
        PutColumn(flight.history[i], before_->stages[kHistory[i]], lane);
      }
    }
  }

  /// Takes all lanes a step further. Those that are not to take the next one here leave their lanes
  /// and go to `leave`.
  template <class Leave>
  void Advance(CrossingFeed& feed, const Leave& leave) {
    if (departures_.any()) departures_.Start(problem_.constants, *start_);
    StepAll();
    const bool all_plain = AcceptPlain();
    if (!all_plain) SettleAll(feed);
    MoveOn(all_plain);
    for (int lane = 0; lane < kN && !(kRemembers && all_plain); ++lane) {
      const bool steady = all_plain || lanes_[lane].steady;
      if (lanes_[lane].busy && Leaves(steady)) leave(Take(lane));
    }
    if constexpr (kRemembers) std::swap(step_, before_);
  }

 private:
  using V = typename Layout::Orbit;
  static constexpr bool kRemembers = kMemory == Memory::kStepBefore;
  static constexpr bool kWithTangents = Layout::kTangents > 0;

  struct Lane {
    bool busy = false;
    bool landing = false;  ///< the step goes to the section
    bool steady = false;   ///< the step just taken counts, and the next is as long
    int ticket = 0;
    int passes = 0;  ///< steps to the section so far
    double up = 1;   ///< sign of γ₃
  };

  int IdleLane() const {
    int lane = 0;
    while (lanes_[lane].busy) ++lane;
    return lane;
  }

  /// Whether a lane takes its next step elsewhere.
  bool Leaves(bool steady) const {
    return steady != kRemembers && problem_.longest_step <= kLongestTwoStep;
  }

  /// An idle lane computes on, harmlessly.
  void Park(int lane) {
    lanes_[lane] = {};
    PutColumn<Layout>({}, *start_, lane);
    start_->time[lane] = 0;
    steps_[lane] = 0;
    start_value_[lane] = 0;
    start_side_[lane] = 0;
    length_[lane] = direction_ * problem_.longest_step;
    gravity_[lane] = problem_.constants.gravity;
    if constexpr (kRemembers) {
      for (const int stage : kHistory) PutColumn<Layout>({}, step_->stages[stage], lane);
    }
  }

  void Begin(CrossingFeed& feed, int lane, const CrossingTask& task, int ticket) {
    Park(lane);
    Lane& own = lanes_[lane];
    own.busy = true;
    own.ticket = ticket;
    own.up = task.state[5] > 0 ? 1 : -1;
    ++busy_;
    gravity_[lane] = own.up * problem_.constants.gravity;
    const auto gamma = task.state.template tail<3>();
    const double tilt = gamma.template head<2>().squaredNorm() / (gamma[2] * gamma[2]);
    if (!(tilt < kMostTilt)) {
      return Finish(feed, lane, LostOrbit(task.state, 0, kTilted), Crossing());
    }
    departures_.Add(task, problem_.stone.parameters().mass, lane);
  }

  Flight<Layout> Take(int lane) {
    const Lane& own = lanes_[lane];
    Flight<Layout> flight{.landing = own.landing,
                          .ticket = own.ticket,
                          .passes = own.passes,
                          .steps = steps_[lane],
                          .time = start_->time[lane],
                          .length = length_[lane],
                          .gravity = gravity_[lane],
                          .value = start_value_[lane],
                          .side = start_side_[lane],
                          .state = ColumnOf(*start_, lane),
                          .history = {}};
    if constexpr (!kRemembers) {
      for (std::size_t i = 0; i < kHistory.size(); ++i) {
        flight.history[i] = ColumnOf(step_->stages[kHistory[i]], lane);
      }
    }
    Park(lane);
    --busy_;
    return flight;
  }

  /// One step of all lanes, and what there is to know of its outcome.
  void StepAll() {
    const V length = Load<V>(length_);
    const V one = Set<V>(1);
    const Stride<V> stride{length, one / length, Load<V>(gravity_)};
    Step<Layout>(problem_.constants, stride, *start_, kRemembers ? before_->stages : nullptr,
                 *step_, *end_);

    V x[kComponents], error[kComponents];
    const auto locate = [&](const double* orbit, double* values, double* sides) HWY_ATTR {
      LoadAll(orbit, x);
      const SectionPlace<V> place = Locate(problem_.constants, problem_.event.cosine(),
                                           problem_.event.sine(), stride.gravity, x);
      Store(place.value, values);
      Store(place.side, sides);
    };
    locate(step_->middle, middle_value_, middle_side_);
    locate(end_->values, end_value_, end_side_);
    // Errors relative to |ω| (or the frequency of gravity, if that is more) and to |(q, 1)|.
    LoadAll(step_->error, error);
    LoadAll(start_->values, x);
    const V spin =
        Fma(x[2], x[2], Fma(x[1], x[1], Fma(x[0], x[0], Set<V>(problem_.constants.least_spin))));
    const V tilt = Fma(x[4], x[4], Fma(x[3], x[3], one));
    const V spin_error = Fma(error[2], error[2], Fma(error[1], error[1], error[0] * error[0]));
    const V tilt_error = Fma(error[4], error[4], error[3] * error[3]);
    Store(Fma(spin_error, tilt, tilt_error * spin) /
              ((tilt * spin) * Set<V>(problem_.tolerance * problem_.tolerance)),
          ratio_);
    Store(Load<V>(steps_) + one, steps_);
  }

  /// Accepts the steps of which Settle would say no more than that; whether these are all. In
  /// doubt, as where a number is NaN, it leaves them to Settle.
  bool AcceptPlain() {
    const V no = Set<V>(0);
    V plain = Set<V>(1);
    const auto at_most = [&](const V& a, const V& b)
                             HWY_ATTR { plain = IfLessEqual(a, b, plain, no); };
    at_most(Load<V>(ratio_), Set<V>(kCalm));
    at_most(Set<V>(problem_.longest_step), Load<V>(length_) * Set<V>(direction_));
    at_most(Load<V>(steps_), Set<V>(problem_.most_steps));
    at_most(Load<V>(end_->time) * Set<V>(direction_), Set<V>(problem_.longest_time));
    const V q1 = Load<V>(end_->values + 3 * kN), q2 = Load<V>(end_->values + 4 * kN);
    at_most(Fma(q2, q2, q1 * q1), Set<V>(0.99 * kMostTilt));
    const auto same_sign = [&](const double* a, const double* b) HWY_ATTR {
      at_most(Set<V>(std::numeric_limits<double>::min()), Load<V>(a) * Load<V>(b));
    };
    same_sign(start_value_, middle_value_);
    same_sign(middle_value_, end_value_);
    same_sign(start_side_, middle_side_);
    same_sign(middle_side_, end_side_);
    Store(plain, accept_);
    return AllLessEqual(Set<V>(1), plain);
  }

  /// Decides about those that are not plain.
  void SettleAll(CrossingFeed& feed) {
    if (!kRemembers &&
        std::any_of(lanes_, lanes_ + kN, [](const Lane& lane) { return lane.landing; })) {
      TouchDown(problem_, gravity_, *end_, arrivals_);
    }
    for (int lane = 0; lane < kN; ++lane) {
      lanes_[lane].steady = accept_[lane] > 0;
      if (accept_[lane] == 0 && lanes_[lane].busy) Settle(feed, lane);
    }
  }

  /// Decides what the step just taken means to a lane.
  void Settle(CrossingFeed& feed, int lane) {
    Lane& own = lanes_[lane];
    if (own.landing) return Land(feed, lane);
    if (steps_[lane] > problem_.most_steps)
      return Lose(feed, lane, absl::StrCat("no crossing within ", problem_.most_steps, " steps"));
    if (!(ratio_[lane] <= 1)) return Shorten(feed, lane);

    const Look begin{0, sense_ * start_value_[lane], start_side_[lane]};
    const Look middle{kNodes[kMiddleStage], sense_ * middle_value_[lane], middle_side_[lane]};
    const Look end{1, sense_ * end_value_[lane], end_side_[lane]};
    const auto look = [&](double part) { return LookAt(lane, part); };
    std::optional<double> crossing = CrossingPart(begin, middle, end, look);
    if (!crossing) crossing = CrossingPart(middle, end, begin, look);
    if (crossing) return Approach(lane, *crossing);

    if (!(end_tilt(lane) < kMostTilt)) return Lose(feed, lane, kTilted);
    if (std::abs(end_->time[lane]) > problem_.longest_time)
      return Lose(feed, lane, "no crossing within the longest time");
    accept_[lane] = 1;
    const double now = std::abs(length_[lane]);
    own.steady = now >= problem_.longest_step && ratio_[lane] <= kCalm;
    if (!own.steady) {
      length_[lane] = direction_ * std::min(problem_.longest_step, now * StepFactor(ratio_[lane]));
    }
  }

  double end_tilt(int lane) const {
    const double q1 = end_->values[3 * kN + lane];
    const double q2 = end_->values[4 * kN + lane];
    return q1 * q1 + q2 * q2;
  }

  void Shorten(CrossingFeed& feed, int lane) {
    length_[lane] *= StepFactor(ratio_[lane]);
    if (!(std::abs(length_[lane]) > kShortestStep)) Lose(feed, lane, "no step is accurate enough");
  }

  /// Starts the next step at the end of this one, where it was accepted.
  void MoveOn(bool all) {
    const V one = Set<V>(1);
    const V accept = Load<V>(accept_);
    const auto take = [&](const double* from, double* to) HWY_ATTR {
      Store(IfLessEqual(one, accept, Load<V>(from), Load<V>(to)), to);
    };
    take(end_value_, start_value_);
    take(end_side_, start_side_);
    if (all) return std::swap(start_, end_);
    take(end_->time, start_->time);
    if constexpr (Layout::kAlike) {
      for (int i = 0; i < Layout::kSize; i += kN) take(end_->values + i, start_->values + i);
    } else {
      if (accept_[0] > 0) std::copy_n(end_->values, Layout::kSize, start_->values);
    }
  }

  Look LookAt(int lane, double part) const {
    const auto place = PlaceAt(problem_, PartOfStep(lane, part), gravity_[lane]);
    return {part, sense_ * place.value, place.side};
  }

  /// Sets the lane to step from where it is to the section, which the step just taken crosses at
  /// `part`.
  void Approach(int lane, double part) {
    lanes_[lane].landing = true;
    start_value_[lane] = 0;  // a step to the section is never a plain one
    length_[lane] *= part;
  }

  FastState PartOfStep(int lane, double part) const {
    const auto weights = PartWeights(part);
    FastState x = OrbitOf(*start_, lane);
    for (std::size_t j = 0; j < weights.size(); ++j) {
      x += weights[j] * OrbitOf(step_->stages[kInterpolated[j]], lane);
    }
    return x;
  }

  /// The lane has stepped to the section, but for a little.
  void Land(CrossingFeed& feed, int lane) {
    Lane& own = lanes_[lane];
    const double rest = arrivals_.rest[lane];
    if (std::abs(rest) <= kTiny * std::abs(length_[lane])) {
      const double mass = problem_.stone.parameters().mass;
      return Finish(feed, lane, absl::OkStatus(), arrivals_.At(mass, lane));
    }
    if (++own.passes > kMostPasses || !std::isfinite(rest)) {
      return Lose(feed, lane, "touches the section, does not cross it");
    }
    length_[lane] += rest;
  }

  void Lose(CrossingFeed& feed, int lane, absl::string_view why) {
    Finish(feed, lane,
           LostOrbit(ToMomentum(problem_.stone, OrbitOf(*start_, lane), lanes_[lane].up),
                     start_->time[lane], why),
           Crossing());
  }

  void Finish(CrossingFeed& feed, int lane, const absl::Status& status, const Crossing& crossing) {
    const int ticket = lanes_[lane].ticket;
    Park(lane);
    --busy_;
    feed.Done(ticket, status, crossing);
  }

  static FastState OrbitOf(const States<Layout>& states, int lane) {
    FastState x;
    for (int i = 0; i < kComponents; ++i) x[i] = states.values[i * kN + lane];
    return x;
  }

  static constexpr double kShortestStep = 1e-12;  // in scaled time, where the steps are about 0.3
  /// Part of a step below which the cube of it is rounding.
  static constexpr double kTiny = 3e-5;
  static constexpr int kMostPasses = 10;
  /// |q|² where |γ₃| is the least that is allowed.
  static constexpr double kMostTilt = 1 / (kLeastGamma3 * kLeastGamma3) - 1;
  static constexpr const char* kTilted = "gamma3 goes to 0, the contact point to infinity";

  const Problem& problem_;
  const double direction_;  ///< of time
  const double sense_;      ///< e times this grows through zero at a crossing
  int busy_ = 0;
  Lane lanes_[kN];
  States<Layout> states_[2];
  States<Layout>* start_ = states_;    ///< of the step
  States<Layout>* end_ = states_ + 1;  ///< of the step
  Departures<Layout> departures_;
  Arrivals<Layout> arrivals_;
  StepResult<Layout> results_[kRemembers ? 2 : 1];
  StepResult<Layout>* step_ = results_;
  StepResult<Layout>* before_ = results_ + (kRemembers ? 1 : 0);
  // Of each lane: the steps so far, the step, and what is known of its outcome. The event's value
  // and side are 0 at the start of all.
  HWY_ALIGN double steps_[kN];
  HWY_ALIGN double length_[kN];
  HWY_ALIGN double gravity_[kN];
  HWY_ALIGN double ratio_[kN];  ///< square of the error over what is allowed
  HWY_ALIGN double start_value_[kN];
  HWY_ALIGN double start_side_[kN];
  HWY_ALIGN double middle_value_[kN];
  HWY_ALIGN double middle_side_[kN];
  HWY_ALIGN double end_value_[kN];
  HWY_ALIGN double end_side_[kN];
  HWY_ALIGN double accept_[kN];
};

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_LANES_INL_H_
