#pragma once

#include "core/integrate/crossing.h"
#include "core/model/celtic_stone.h"

namespace celt::bench {

/// Boost.odeint 1.74 in the place of one of our engines, forward in time: what a careful user of it
/// would write (odeint_crossing.h).
class OdeintEngine final : public SectionEngine {
 public:
  OdeintEngine(const CelticStone& stone, double section_angle, double tolerance)
      : stone_(stone), section_angle_(section_angle), tolerance_(tolerance) {}
  void Run(CrossingFeed& feed, Direction direction, Derivative derivative) const override;

 private:
  template <int kTangents>
  absl::Status Cross(const CrossingTask& task, Crossing& crossing) const;

  CelticStone stone_;
  double section_angle_;
  double tolerance_;
};

}  // namespace celt::bench
