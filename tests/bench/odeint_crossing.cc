#include "tests/bench/odeint_crossing.h"

#include <cmath>

#include "boost/numeric/odeint/stepper/controlled_runge_kutta.hpp"
#include "boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp"
#include "boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp"
#include "boost/numeric/odeint/stepper/generation/make_controlled.hpp"
#include "boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp"
// The very field that the fast engine has, hand-written tangents and all, one lane wide and
// compiled for this machine.
#include "core/integrate/fast/section_value-inl.h"
#include "core/integrate/fast/stone_rate-inl.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace celt::bench {
namespace {

namespace odeint = boost::numeric::odeint;
using namespace fast::HWY_NAMESPACE;  // NOLINT: where the field is
using One = Lanes<1>;

template <int kTangents>
struct Field {
  const OdeintProblem& problem;

  void operator()(const OdeintState<kTangents>& x, OdeintState<kTangents>& rate, double) const {
    One in[kComponents], out[kComponents], scale;
    for (int i = 0; i < kComponents; ++i) in[i] = Set<One>(x[i]);
    const Stride<One> unit{Set<One>(1), Set<One>(1), Set<One>(problem.gravity)};
    Linearization<One> linear;
    Rate<(kTangents > 0)>(problem.constants, unit, in, out, scale, linear);
    const double over = 1 / hn::GetLane(scale);  // from scaled time to time
    for (int i = 0; i < kComponents; ++i) rate[i] = over * hn::GetLane(out[i]);
    for (int j = 1; j <= kTangents; ++j) {
      for (int i = 0; i < kComponents; ++i) in[i] = Set<One>(x[j * kComponents + i]);
      TangentRate(linear, in, out);
      for (int i = 0; i < kComponents; ++i) {
        rate[j * kComponents + i] = over * hn::GetLane(out[i]);
      }
    }
  }
};

template <class State>
SectionPlace<double> Place(const OdeintProblem& problem, const State& x) {
  One in[kComponents];
  for (int i = 0; i < kComponents; ++i) in[i] = Set<One>(x[i]);
  const auto place =
      Locate(problem.constants, problem.cosine, problem.sine, Set<One>(problem.gravity), in);
  return {hn::GetLane(place.value), hn::GetLane(place.side)};
}

template <class State>
State Moved(const State& x, const State& rate, double time) {
  State moved;
  for (std::size_t i = 0; i < x.size(); ++i) moved[i] = x[i] + time * rate[i];
  return moved;
}

/// From `last`, before the section, to it; `length` of the step that goes past.
template <int kTangents>
void Land(const OdeintProblem& problem, const OdeintState<kTangents>& last, double guess,
          OdeintState<kTangents>& state, OdeintState<kTangents>& rate, double& time) {
  constexpr double kNear = 1e-7;  // of a step: Euler's is then exact
  constexpr double kProbe = 1e-7;
  constexpr int kMostPasses = 8;
  const Field<kTangents> field{problem};
  odeint::runge_kutta_fehlberg78<OdeintState<kTangents>> stepper;
  double length = guess;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    state = last;
    stepper.do_step(field, state, 0.0, length);
    field(state, rate, 0);
    const double value = Place(problem, state).value;
    const double slope = (Place(problem, Moved(state, rate, kProbe)).value - value) / kProbe;
    const double rest = -value / slope;
    if (std::abs(rest) < kNear * guess || pass + 1 == kMostPasses) {
      state = Moved(state, rate, rest);
      field(state, rate, 0);
      time += length + rest;
      return;
    }
    length += rest;
  }
}

}  // namespace

template <int kTangents>
bool CrossByOdeint(const OdeintProblem& problem, OdeintState<kTangents>& state,
                   OdeintState<kTangents>& rate, double& time) {
  using State = OdeintState<kTangents>;
  const Field<kTangents> field{problem};
  auto stepper = odeint::make_controlled(problem.tolerance, problem.tolerance,
                                         odeint::runge_kutta_fehlberg78<State>());
  constexpr int kMostSteps = 20'000;
  double length = 0.01;
  double before = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const State last = state;
    const double start = time;
    while (stepper.try_step(field, state, time, length) != odeint::success) {
    }
    const auto place = Place(problem, state);
    if (before < 0 && place.value >= 0 && place.side > 0) {
      const double guess = (time - start) * before / (before - place.value);
      time = start;
      Land<kTangents>(problem, last, guess, state, rate, time);
      return true;
    }
    before = place.value;
  }
  return false;
}

template bool CrossByOdeint<0>(const OdeintProblem&, OdeintState<0>&, OdeintState<0>&, double&);
template bool CrossByOdeint<3>(const OdeintProblem&, OdeintState<3>&, OdeintState<3>&, double&);

}  // namespace celt::bench
HWY_AFTER_NAMESPACE();
