#pragma once

#include <memory>

#include "core/integrate/crossing.h"
#include "core/integrate/crossing_limits.h"
#include "core/model/celtic_stone.h"

namespace celt {

struct FastOptions {
  CrossingLimits limits;
  /// Orbits side by side: 1, 4, 8 or 16, or 0 for what is fastest on this machine. No result
  /// depends on it.
  int lanes = 0;
};

/// The section engine to use: explicit Runge–Kutta for many orbits at once, side by side in the
/// lanes of the machine's vectors (AVX-512, AVX2, NEON; found at run time), each orbit with its own
/// steps and its own end, a lane taking the feed's next task as soon as it is free.
///
/// Equations: (ω, q) with q = (γ₁, γ₂)/γ₃ in place of (M, γ), in a scaled time in which equal steps
/// err about equally (stone_rate-inl.h). Method: Verner's pair of orders 9(8) (verner98.h),
/// tangents in the same stages. The step in scaled time is 4.3 tolerance^(1/9), and shorter only
/// where the pair's error estimate for the orbit exceeds 300 tolerances, relative to |ω| and |(q,
/// 1)|. So tangents have no say in the steps, and an orbit is the same to the last bit with them
/// and without.
///
/// Accuracy over the attractor of the default stone at E = 752, largest error of one iterate
/// against quadruple precision; time of an iterate [µs] on one core of an AMD EPYC 9004 at 3.7 GHz
/// (a 512-bit multiply-add each cycle):
///
///     tolerance |  map      Jacobian (relative) | many orbits   with tangents | one orbit   with
///     tangents 1e-11     |  4.4e-11  2.1e-10             | 4.1           9.9           | 21 35
///     1e-12     |  1.8e-12  1.0e-11             | 5.2           12.5          |
///     1e-13     |  1.1e-13  1.3e-12             | 6.5           16            |
///
/// That is, the map errs by at most 5 tolerances, the Jacobian by 30.
///
/// The section is found where e of section_event.h changes its sign, looked at twice a step, and
/// landed on by a step of the method itself from the last state before it; what is then left, about
/// a millionth of a step, is Newton's on time, and |g − g₀| ends at rounding. A pair of crossings
/// within half a step of each other, where the orbit all but touches the section, is not seen.
///
/// Tasks must have tangents that are tangent to |γ| = 1; what they have along γ is dropped. Both
/// signs of γ₃ will do, γ₃ = 0 will not: a task that starts next to it is lost at t = 0.
///
/// A result depends on its task alone, to the last bit: not on the number of lanes, on neighbours
/// or on the order; it may differ between machines with fused multiply-add and those without.
class FastSectionEngine final : public SectionEngine {
 public:
  /// `section_angle` is g₀ [rad], body frame. Preconditions: CheckStone(stone.parameters()) is OK,
  /// `tolerance` is in [1e-14, 1e-3], `lanes` one of those that it may be.
  FastSectionEngine(const CelticStone& stone, double section_angle, double tolerance,
                    const FastOptions& options = {});
  ~FastSectionEngine() override;
  void Run(CrossingFeed& feed, Direction direction, Derivative derivative) const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace celt
