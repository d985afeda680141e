#pragma once

#include <memory>

#include "core/integrate/crossing.h"
#include "core/integrate/crossing_limits.h"
#include "core/integrate/section_event.h"
#include "core/model/celtic_stone.h"

namespace celt {

struct FastOptions {
  CrossingLimits limits = {};
  /// Orbits side by side: 1, 4, 8 or 16, or 0 for what is fastest on this machine. No result
  /// depends on it.
  int lanes = 0;
};

/// The section engine to use: explicit Runge–Kutta for many orbits at once, side by side in the
/// lanes of the machine's vectors (AVX-512, AVX2, NEON; found at run time), each orbit with its own
/// steps and its own end. Up to twice as many orbits are under way as there are lanes, since those
/// that begin or end have lanes of their own.
///
/// Equations: (ω, q) with q = (γ₁, γ₂)/γ₃ in place of (M, γ), in a scaled time in which equal steps
/// err about equally (stone_rate-inl.h). Method: the ninth-order one of Verner's pair of orders
/// 9(8) (verner9.h), with three of its fifteen stages less where a step follows one of its own
/// length (two_step.h); tangents in the same stages. The step in scaled time is 4.2
/// tolerance^(1/9), and shorter only where an error estimate for the orbit exceeds 30
/// tolerance^(8/9), relative to |ω| and |(q, 1)|. So tangents have no say in the steps, and an
/// orbit is the same to the last bit with them and without. The map errs by at most 5 tolerances,
/// its Jacobian by 30 (section_engine.h has a table).
///
/// The section is found where e of section_event.h changes its sign, looked at twice a step, and
/// landed on by a step of the method itself from the last state before it; what is then left, about
/// a millionth of a step, is Newton's on time, and |g − g₀| ends at rounding. Where an orbit passes
/// |L/G| = 1 or |H/G| = 1 so closely that g makes half a turn between two looks, the crossing is
/// found too. Where g itself turns back, within half a step of g₀, a pair of crossings is not seen.
///
/// Tasks must have tangents that are tangent to |γ| = 1; what they have along γ is dropped. Both
/// signs of γ₃ will do, γ₃ = 0 will not: a task that starts next to it is lost at t = 0.
///
/// A result depends on its task alone, to the last bit: not on the number of lanes, on neighbours
/// or on the order; it may differ between machines with fused multiply-add and those without.
class FastSectionEngine final : public SectionEngine {
 public:
  /// Preconditions: CheckStone(stone.parameters()) is OK,
  /// `tolerance` is in [1e-14, 1e-3], `lanes` one of those that it may be.
  FastSectionEngine(const CelticStone& stone, const SectionEvent& section, double tolerance,
                    const FastOptions& options = {});
  ~FastSectionEngine() override;
  void Run(CrossingFeed& feed, Direction direction, Derivative derivative) const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace celt
