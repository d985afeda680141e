#pragma once

#include <memory>
#include <span>

#include "absl/status/status.h"

namespace celt {

/// An autonomous initial value problem ẏ = f(y) as an integrator sees it: numbers without names,
/// and a norm in which to measure the error of a step.
class OdeProblem {
 public:
  virtual ~OdeProblem() = default;
  virtual int size() const = 0;
  /// Writes f(y). False: f is not defined at y, and the integrator has to try a smaller step.
  virtual bool Rate(std::span<const double> y, std::span<double> rate) const = 0;
  /// Writes, for each component, one over the error that one step may make in it.
  virtual void Weights(std::span<const double> y, std::span<double> weights) const = 0;
};

/// Advances an OdeProblem step by step, each step as long as the error allows. Not safe to share
/// between threads.
class OdeStepper {
 public:
  virtual ~OdeStepper() = default;

  /// Takes one step from time() towards `stop`, never beyond; time() equals `stop` exactly when the
  /// step got there. `stop` must lie on the same side of time() in every call, and further than
  /// rounding from it. OUT_OF_RANGE: no step, however short, is accurate enough; state() is then
  /// where the last good step led.
  virtual absl::Status Step(double stop) = 0;

  /// Time since the start, negative when going backward.
  virtual double time() const = 0;
  virtual std::span<const double> state() const = 0;
};

/// Variable-order Adams–Moulton of order up to 12 (CVODE; Hindmarsh et al., ACM TOMS 31, 2005),
/// corrected by fixed-point iteration. Starts at order one with tiny steps: at its best over long
/// stretches. `problem` must outlive the stepper.
std::unique_ptr<OdeStepper> MakeAdamsStepper(const OdeProblem& problem,
                                             std::span<const double> start);

/// Explicit Runge–Kutta pair of orders 8(7) in 13 stages (Fehlberg, NASA TR R-287, 1968; ARKODE's
/// ERKStep, Reynolds et al., ACM TOMS 49, 2023). `problem` must outlive the stepper.
std::unique_ptr<OdeStepper> MakeRungeKuttaStepper(const OdeProblem& problem,
                                                  std::span<const double> start,
                                                  double first_step = 0);

}  // namespace celt
