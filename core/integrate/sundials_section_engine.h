#pragma once

#include <memory>

#include "core/integrate/crossing.h"
#include "core/integrate/crossing_limits.h"
#include "core/integrate/ode_stepper.h"
#include "core/integrate/section_event.h"
#include "core/integrate/stone_problem.h"
#include "core/model/celtic_stone.h"

namespace celt {

enum class SteppingMethod { kAdams, kRungeKutta };

/// A SectionEngine on SUNDIALS. It goes step by step until e of SectionEvent changes sign the right
/// way, and then from the last step before it lands on the section by steps of the integrator's
/// own, whose length is found by Newton's method on time: no interpolation enters, and |g − g₀|
/// ends at rounding. Landing is by Runge–Kutta steps whatever the method, for an Adams method would
/// have to build up its order anew.
///
/// Each task gets an integrator of its own, so that nothing of one orbit can leak into another. One
/// lane. Crossings that come and go within a single step are not seen; steps follow the solution
/// much more closely than that, but for orbits that all but touch the section.
class SundialsSectionEngine final : public SectionEngine {
 public:
  SundialsSectionEngine(const CelticStone& stone, const SectionEvent& section,
                        SteppingMethod method, double tolerance, const CrossingLimits& limits = {});

  void Run(CrossingFeed& feed, Direction direction, Derivative derivative) const override;

 private:
  struct Leg;

  absl::StatusOr<Crossing> Cross(const CrossingTask& task, Direction direction,
                                 Derivative derivative) const;
  absl::StatusOr<Leg> FindLanding(const OdeProblem& problem, const CrossingTask& task,
                                  double sign) const;
  absl::Status Land(const OdeProblem& problem, Leg& leg) const;
  std::unique_ptr<OdeStepper> MakeStepper(const OdeProblem& problem,
                                          std::span<const double> start) const;
  double EventRate(const StoneState& state) const;

  CelticStone stone_;
  SectionEvent event_;
  SteppingMethod method_;
  double tolerance_;
  double longest_time_;
  int most_steps_;
};

}  // namespace celt
