// Compiled once for each SIMD target: included by files that go through hwy/foreach_target.h.
//
// A group of lanes, each on its own way to its own crossing. Steps are taken together; everything
// else is each lane's own affair. A lane that is through takes the feed's next task at once.
//
// Steps are kLongestStep (lanes.h) long in scaled time unless the error estimate objects: the
// estimate, of an order less than the solution, swings over a factor of a thousand along an orbit
// whose error per step hardly changes, and control by it takes a fifth more steps for the same
// accuracy.
#if defined(CELT_FAST_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CELT_FAST_LANES_INL_H_
#undef CELT_FAST_LANES_INL_H_
#else
#define CELT_FAST_LANES_INL_H_
#endif

#include <algorithm>
#include <array>
#include <cmath>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "core/integrate/crossing.h"
#include "core/integrate/fast/coordinates.h"
#include "core/integrate/fast/landing.h"
#include "core/integrate/fast/lanes.h"
#include "core/integrate/fast/runge_kutta-inl.h"
#include "core/integrate/fast/section_value-inl.h"
#include "core/integrate/fast/touchdown-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::fast::HWY_NAMESPACE {

template <class Layout>
class Group {
 public:
  /// `step` is room to work in, for one group at a time.
  Group(const Problem& problem, Direction direction, StepResult<Layout>& step)
      : problem_(problem), direction_(direction == Direction::kForward ? 1 : -1), step_(step) {
    for (int lane = 0; lane < kN; ++lane) Park(lane);
  }

  bool busy() const { return busy_ > 0; }

  /// Gives idle lanes work, as far as there is some.
  void Fill(CrossingFeed& feed) {
    CrossingTask task;
    for (int lane = 0; lane < kN; ++lane) {
      if (lanes_[lane].busy) continue;
      int ticket = 0;
      if (!feed.Next(task, ticket)) return;
      Begin(feed, lane, task, ticket);
    }
  }

  /// Takes all lanes a step further.
  void Advance(CrossingFeed& feed) {
    StepAll();
    for (int lane = 0; lane < kN; ++lane) {
      accept_[lane] = 0;
      if (lanes_[lane].busy) Settle(feed, lane);
    }
    Accept();
  }

 private:
  using V = typename Layout::Orbit;
  static constexpr int kN = Layout::kOrbits;
  static constexpr bool kWithTangents = Layout::kTangents > 0;

  struct Lane {
    bool busy = false;
    bool landing = false;  ///< the step goes to the section
    int ticket = 0;
    int steps = 0;
    int passes = 0;     ///< steps to the section so far
    double up = 1;      ///< sign of γ₃
    double before = 0;  ///< e at the start of the step; 0 at the start of all
  };

  /// An idle lane computes on, harmlessly.
  void Park(int lane) {
    lanes_[lane] = {};
    PutOrbit(lane, FastState::Zero());
    if constexpr (kWithTangents) PutTangents(lane, FastTangents::Zero());
    start_.time[lane] = 0;
    length_[lane] = direction_ * problem_.longest_step;
    gravity_[lane] = problem_.constants.gravity;
  }

  void Begin(CrossingFeed& feed, int lane, const CrossingTask& task, int ticket) {
    Park(lane);
    Lane& own = lanes_[lane];
    own.busy = true;
    own.ticket = ticket;
    own.up = task.state[5] > 0 ? 1 : -1;
    ++busy_;
    gravity_[lane] = own.up * problem_.constants.gravity;
    const FastState x = FromMomentum(problem_.stone, task.state);
    PutOrbit(lane, x);
    if constexpr (kWithTangents) {
      PutTangents(lane, FromMomentum(problem_.stone, x, own.up, task.tangents));
    }
    if (!(x.template tail<2>().squaredNorm() < kMostTilt)) Lose(feed, lane, kTilted);
  }

  /// One step of all lanes, and what there is to know of its outcome.
  void StepAll() {
    const V length = Load<V>(length_);
    const V one = Set<V>(1);
    const Stride<V> stride{length, one / length, Load<V>(gravity_)};
    Step<Layout>(problem_.constants, stride, start_, step_);

    V x[kComponents], error[kComponents];
    const auto locate = [&](const double* orbit, double* values, double* sides) HWY_ATTR {
      LoadAll(orbit, x);
      const SectionPlace<V> place =
          Locate(problem_.constants, problem_.cosine, problem_.sine, stride.gravity, x);
      Store(place.value, values);
      Store(place.side, sides);
    };
    locate(step_.middle, middle_value_, middle_side_);
    locate(step_.end.values, end_value_, end_side_);
    // Errors relative to |ω| (or the frequency of gravity, if that is more) and to |(q, 1)|.
    LoadAll(step_.error, error);
    LoadAll(start_.values, x);
    const V spin =
        Fma(x[2], x[2], Fma(x[1], x[1], Fma(x[0], x[0], Set<V>(problem_.constants.least_spin))));
    const V tilt = Fma(x[4], x[4], Fma(x[3], x[3], one));
    const V spin_error = Fma(error[2], error[2], Fma(error[1], error[1], error[0] * error[0]));
    const V tilt_error = Fma(error[4], error[4], error[3] * error[3]);
    Store(Fma(spin_error, tilt, tilt_error * spin) /
              ((tilt * spin) * Set<V>(problem_.tolerance * problem_.tolerance)),
          ratio_);
  }

  /// Decides what the step just taken means to a lane.
  void Settle(CrossingFeed& feed, int lane) {
    Lane& own = lanes_[lane];
    if (own.landing) return Land(feed, lane);
    if (++own.steps > problem_.most_steps)
      return Lose(feed, lane, absl::StrCat("no crossing within ", problem_.most_steps, " steps"));
    if (!(ratio_[lane] <= 1)) return Shorten(feed, lane);

    const PartValue begin{0, own.before};
    const PartValue middle{kNodes[kMiddleStage], direction_ * middle_value_[lane]};
    const PartValue end{1, direction_ * end_value_[lane]};
    if (begin.value < 0 && middle.value >= 0 && middle_side_[lane] > 0)
      return Approach(lane, begin, middle, end);
    if (middle.value < 0 && end.value >= 0 && end_side_[lane] > 0)
      return Approach(lane, middle, end, begin);

    if (!(end_tilt(lane) < kMostTilt)) return Lose(feed, lane, kTilted);
    if (std::abs(step_.end.time[lane]) > problem_.longest_time)
      return Lose(feed, lane, "no crossing within the longest time");
    own.before = end.value;
    accept_[lane] = 1;
    const double now = std::abs(length_[lane]);
    if (now < problem_.longest_step || ratio_[lane] > kCalm) {
      length_[lane] = direction_ * std::min(problem_.longest_step, now * StepFactor(ratio_[lane]));
    }
  }

  double end_tilt(int lane) const {
    const double q1 = step_.end.values[3 * kN + lane];
    const double q2 = step_.end.values[4 * kN + lane];
    return q1 * q1 + q2 * q2;
  }

  void Shorten(CrossingFeed& feed, int lane) {
    length_[lane] *= StepFactor(ratio_[lane]);
    if (!(std::abs(length_[lane]) > kShortestStep)) Lose(feed, lane, "no step is accurate enough");
  }

  /// Takes over the end of the step where it was accepted.
  void Accept() {
    const V one = Set<V>(1);
    const V accept = Load<V>(accept_);
    const auto take = [&](const double* from, double* to) HWY_ATTR {
      Store(IfLessEqual(one, accept, Load<V>(from), Load<V>(to)), to);
    };
    take(step_.end.time, start_.time);
    if constexpr (Layout::kAlike) {
      for (int i = 0; i < Layout::kSize; i += kN) take(step_.end.values + i, start_.values + i);
    } else {
      if (accept_[0] > 0) std::copy_n(step_.end.values, Layout::kSize, start_.values);
    }
  }

  /// Sets the lane to step from where it is to the section, which the step just taken crosses
  /// between `low` and `high`.
  void Approach(int lane, PartValue low, PartValue high, PartValue other) {
    lanes_[lane].landing = true;
    const double part = FindCrossing(low, high, other, [&](double at) {
      return direction_ * ValueAt(problem_, PartOfStep(lane, at), gravity_[lane]);
    });
    length_[lane] *= part;
  }

  FastState PartOfStep(int lane, double part) const {
    const auto weights = PartWeights(part);
    FastState x = OrbitOf(start_, lane);
    for (std::size_t j = 0; j < weights.size(); ++j) {
      x += weights[j] * OrbitOf(step_.stages[kInterpolated[j]], lane);
    }
    return x;
  }

  /// The lane has stepped to the section, but for a little.
  void Land(CrossingFeed& feed, int lane) {
    Lane& own = lanes_[lane];
    FastTangents tangents;
    if constexpr (kWithTangents) tangents = TangentsOf(step_.end, lane);
    Touchdown<kWithTangents> touchdown(problem_, OrbitOf(step_.end, lane), gravity_[lane]);
    const double rest = touchdown.rest();
    if (std::abs(rest) <= kTiny * std::abs(length_[lane])) {
      return Finish(feed, lane, absl::OkStatus(), touchdown.Finish(tangents, step_.end.time[lane]));
    }
    if (++own.passes > kMostPasses || !std::isfinite(rest)) {
      return Lose(feed, lane, "touches the section, does not cross it");
    }
    length_[lane] += rest;
  }

  void Lose(CrossingFeed& feed, int lane, absl::string_view why) {
    Finish(feed, lane,
           LostOrbit(problem_, OrbitOf(start_, lane), lanes_[lane].up, start_.time[lane], why),
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
  void PutOrbit(int lane, const FastState& x) {
    for (int i = 0; i < kComponents; ++i) start_.values[i * kN + lane] = x[i];
  }

  static int TangentAt(int lane, int tangent, int component) {
    return Layout::kTangentStart + (Layout::kAlike ? (tangent * kComponents + component) * kN + lane
                                                   : component * Layout::kTangentLanes + tangent);
  }
  static FastTangents TangentsOf(const States<Layout>& states, int lane) {
    FastTangents tangents;
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < kComponents; ++i) tangents(i, j) = states.values[TangentAt(lane, j, i)];
    }
    return tangents;
  }
  void PutTangents(int lane, const FastTangents& tangents) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < kComponents; ++i) start_.values[TangentAt(lane, j, i)] = tangents(i, j);
    }
  }

  static constexpr double kShortestStep = 1e-12;  // in scaled time, where the steps are about 0.3
  /// Part of a step below which the cube of it is rounding.
  static constexpr double kTiny = 3e-5;
  static constexpr int kMostPasses = 10;
  /// |q|² where |γ₃| is twice the least that the stone's functions allow.
  static constexpr double kMostTilt = 1 / (4 * kLeastGamma3 * kLeastGamma3) - 1;
  static constexpr const char* kTilted = "gamma3 goes to 0, the contact point to infinity";

  const Problem& problem_;
  const double direction_;
  StepResult<Layout>& step_;
  int busy_ = 0;
  Lane lanes_[kN];
  States<Layout> start_;
  // Of each lane: the step, and what is known of its outcome.
  HWY_ALIGN double length_[kN];
  HWY_ALIGN double gravity_[kN];
  HWY_ALIGN double ratio_[kN];  ///< square of the error over what is allowed
  HWY_ALIGN double middle_value_[kN];
  HWY_ALIGN double middle_side_[kN];
  HWY_ALIGN double end_value_[kN];
  HWY_ALIGN double end_side_[kN];
  HWY_ALIGN double accept_[kN];
};

}  // namespace celt::fast::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // CELT_FAST_LANES_INL_H_
