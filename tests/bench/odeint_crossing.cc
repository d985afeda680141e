#include "tests/bench/odeint_crossing.h"

#include <cmath>

#include "boost/numeric/odeint/stepper/controlled_runge_kutta.hpp"
#include "boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp"
#include "boost/numeric/odeint/stepper/generation/generation_runge_kutta_fehlberg78.hpp"
#include "boost/numeric/odeint/stepper/generation/make_controlled.hpp"
#include "boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp"
#include "tests/bench/fast_field.h"
#include "tests/bench/momentum_field.h"

namespace celt::bench {
namespace {

namespace odeint = boost::numeric::odeint;

template <class Equations, int kTangents>
struct Field {
  using State = OdeintState<Equations, kTangents>;
  void operator()(const State& x, State& rate, double) const {
    Rate<kTangents>(equations, x.data(), rate.data());
  }
  const Equations& equations;
};

template <class State>
State Moved(const State& x, const State& rate, double time) {
  State moved;
  for (std::size_t i = 0; i < x.size(); ++i) moved[i] = x[i] + time * rate[i];
  return moved;
}

/// From `last`, before the section, to it, in a step of about `guess`.
template <class Equations, int kTangents>
void Land(const Equations& equations, const OdeintState<Equations, kTangents>& last, double guess,
          OdeintState<Equations, kTangents>& state, OdeintState<Equations, kTangents>& rate,
          double& time) {
  constexpr double kNear = 1e-7;  // of a step: Euler's is then exact
  constexpr double kProbe = 1e-7;
  constexpr int kMostPasses = 8;
  const Field<Equations, kTangents> field{equations};
  odeint::runge_kutta_fehlberg78<OdeintState<Equations, kTangents>> stepper;
  double length = guess;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    state = last;
    stepper.do_step(field, state, 0.0, length);
    field(state, rate, 0);
    const double value = PlaceOf(equations, state.data()).value;
    const double ahead = PlaceOf(equations, Moved(state, rate, kProbe).data()).value;
    const double rest = -value / ((ahead - value) / kProbe);
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

template <class Equations, int kTangents>
bool CrossByOdeint(const Equations& equations, double tolerance,
                   OdeintState<Equations, kTangents>& state,
                   OdeintState<Equations, kTangents>& rate, double& time) {
  using State = OdeintState<Equations, kTangents>;
  const Field<Equations, kTangents> field{equations};
  auto stepper =
      odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<State>());
  constexpr int kMostSteps = 20'000;
  double length = 0.01;
  double before = 0;
  for (int step = 0; step < kMostSteps; ++step) {
    const State last = state;
    const double start = time;
    while (stepper.try_step(field, state, time, length) != odeint::success) {
    }
    const Place place = PlaceOf(equations, state.data());
    if (before < 0 && place.value >= 0 && place.side > 0) {
      const double guess = (time - start) * before / (before - place.value);
      time = start;
      Land<Equations, kTangents>(equations, last, guess, state, rate, time);
      return true;
    }
    before = place.value;
  }
  return false;
}

template <class Equations, int kTangents>
using State = OdeintState<Equations, kTangents>;

template bool CrossByOdeint<FastEquations, 0>(const FastEquations&, double,
                                              State<FastEquations, 0>&, State<FastEquations, 0>&,
                                              double&);
template bool CrossByOdeint<FastEquations, 3>(const FastEquations&, double,
                                              State<FastEquations, 3>&, State<FastEquations, 3>&,
                                              double&);
template bool CrossByOdeint<MomentumEquations, 0>(const MomentumEquations&, double,
                                                  State<MomentumEquations, 0>&,
                                                  State<MomentumEquations, 0>&, double&);
template bool CrossByOdeint<MomentumEquations, 3>(const MomentumEquations&, double,
                                                  State<MomentumEquations, 3>&,
                                                  State<MomentumEquations, 3>&, double&);

}  // namespace celt::bench
