#pragma once

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "celt/v1/system.pb.h"
#include "core/map/map.h"
#include "core/map/system.h"

namespace celt::plans {

/// Between the public contract and the mathematics. INVALID_ARGUMENT names the field.

absl::StatusOr<Numerics> ToNumerics(const v1::Numerics& numerics);
v1::Engine FromEngine(Engine engine);
/// Unspecified is forward.
absl::StatusOr<Direction> ToDirection(v1::Direction direction);
v1::Direction FromDirection(Direction direction);
Parameters ToParameters(const v1::System& system);

/// Points of the contract: named coordinates and a choice of frame for the Celtic stone, plain ones
/// for the rest.
class PointFrame {
 public:
  /// `spec` names a system that exists, with all its parameters.
  explicit PointFrame(const v1::JobSpec& spec);

  /// The point in the map's own coordinates.
  absl::StatusOr<Point> ToPoint(const v1::Point& point) const;
  v1::Point FromPoint(const Point& point) const;
  /// The Andoyer-Deprit angle g [rad] of the stone, given in the body frame.
  double FromG(double g) const;

 private:
  Point Exchange(const Point& point) const;

  bool stone_;
  bool paper_;
  double delta_ = 0;  // of the stone [rad]
};

}  // namespace celt::plans
