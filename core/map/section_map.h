#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/integrate/crossing.h"
#include "core/integrate/section_event.h"
#include "core/map/map.h"
#include "core/model/andoyer.h"
#include "core/model/celtic_stone.h"

namespace celt {

/// The Poincaré map of the Celtic stone on the section g = g₀, crossed with g increasing (or, if
/// the engine is made so, decreasing), of a level H = E of energy. Coordinates x = (l, L/G, H/G) in
/// the body frame, l in [0, 2π) [rad]; core/model/andoyer.h says what they are.
///
/// A point is lifted to (M, γ), carried to its next crossing by a SectionEngine, and projected. The
/// Jacobian is
///
///     DF = P'(y₁) (1 − f nᵀ/(n·f)) Φ L'(x),
///
/// with L' and P' the derivatives of lift and projection, Φ the flow's tangent map over the return
/// time, f the field at the crossing y₁ and n the gradient there of the function that vanishes on
/// the section. Every iterate starts on the level anew, so that energy and |γ| do not drift from
/// one iterate to the next; within an iterate they drift by the integrator's error,
/// which Image::drift tells. Putting the
/// arrival back on the level was measured to raise the map's error, from 1.48e-11 to 2.03e-11 in
/// root mean square at a tolerance of 1e-10, and is left out.
///
/// By SUNDIALS the tangents take part in the choice of steps: an image asked for with its Jacobian
/// and without then agrees within the error only. By the fast engine it is the same to the last
/// bit.
///
/// A start at which g goes the other way is carried to its first crossing like any other, but is
/// the image of no point: there the map has no inverse.
///
/// INVALID_ARGUMENT of Apply and AdvanceAll: a start that is no point of g = g₀ in the level
/// (outside the coordinates' range, empty level, γ₃ = 0). OUT_OF_RANGE: the orbit of a good start
/// was lost later.
class SectionMap final : public Map {
 public:
  /// `engine` must be of the same stone and the same section angle [rad].
  SectionMap(const CelticStone& stone, double energy, double section_angle,
             std::unique_ptr<const SectionEngine> engine);

  int dimension() const override { return 3; }
  absl::Status CheckPoint(const Point& x) const override;
  absl::StatusOr<Image> Apply(const Point& x, Direction direction,
                              Derivative derivative) const override;
  /// Hands all orbits to the engine at once, each next iterate as soon as the one before is done.
  std::vector<absl::Status> AdvanceAll(std::span<const Point> starts, const Advance& advance,
                                       Visit visit) const override;
  /// The first coordinate is an angle.
  Point Difference(const Point& a, const Point& b) const override;
  /// The half turn of the stone about its vertical axis, l → l + π. On the sections g = 0 and g = π
  /// also the reversal of time, (l, L/G, H/G) → (l + π, −L/G, −H/G), and the product of both.
  std::vector<Symmetry> Symmetries() const override;

 private:
  class OrbitFeed;

  absl::StatusOr<LiftedPoint> Lift(const Point& x) const;
  /// How far a state is off the level, relative to kinetic and potential energy, and off |γ| = 1.
  double Drift(const StoneState& state) const;
  absl::StatusOr<Image> ToImage(const Crossing& crossing, Derivative derivative) const;

  CelticStone stone_;
  double energy_;
  double section_angle_;
  SectionEvent event_;
  std::unique_ptr<const SectionEngine> engine_;
};

}  // namespace celt
