#pragma once

#include "core/integrate/crossing.h"
#include "core/model/celtic_stone.h"

namespace celt::bench {

/// Which equations Boost.odeint is given (odeint_crossing.h).
enum class Equations { kMomentum, kFast };

/// Boost.odeint 1.74 in the place of one of our engines, forward in time: what a careful user of it
/// would write (odeint_crossing.h).
class OdeintEngine final : public SectionEngine {
 public:
  OdeintEngine(const CelticStone& stone, double section_angle, double tolerance,
               Equations equations)
      : stone_(stone),
        section_angle_(section_angle),
        tolerance_(tolerance),
        equations_(equations) {}
  void Run(CrossingFeed& feed, Direction direction, Derivative derivative) const override;

 private:
  template <int kTangents>
  bool Cross(const CrossingTask& task, Crossing& crossing) const;
  template <int kTangents>
  bool CrossByMomentum(const CrossingTask& task, Crossing& crossing) const;
  template <int kTangents>
  bool CrossByFast(const CrossingTask& task, Crossing& crossing) const;

  CelticStone stone_;
  double section_angle_;
  double tolerance_;
  Equations equations_;
};

}  // namespace celt::bench
