#include "server/plans/convert.h"

#include <numbers>
#include <string>

#include "absl/strings/str_cat.h"
#include "core/model/andoyer.h"
#include "core/model/angle.h"

namespace celt::plans {
namespace {

constexpr const char* kStone = "celtic-stone";

absl::StatusOr<Point> NamedCoordinates(const v1::Point& point) {
  if (point.x_size() > 0) {
    return absl::InvalidArgumentError(
        "x: not for celtic-stone; its points have l, l_over_g and h_over_g");
  }
  const char* missing = !point.has_l()          ? "l"
                        : !point.has_l_over_g() ? "l_over_g"
                        : !point.has_h_over_g() ? "h_over_g"
                                                : nullptr;
  if (missing != nullptr) {
    return absl::InvalidArgumentError(
        absl::StrCat(missing, ": missing; points of celtic-stone have l, l_over_g and h_over_g"));
  }
  return Point(Eigen::Vector3d(point.l(), point.l_over_g(), point.h_over_g()));
}

absl::StatusOr<Point> PlainCoordinates(const v1::Point& point) {
  if (point.has_l() || point.has_l_over_g() || point.has_h_over_g()) {
    return absl::InvalidArgumentError(
        "l, l_over_g, h_over_g: only for celtic-stone; points of other systems have x");
  }
  if (point.x_size() > kMaxDimension) {
    return absl::InvalidArgumentError(absl::StrCat("x: has ", point.x_size(),
                                                   " coordinates, more than the ", kMaxDimension,
                                                   " of any system"));
  }
  Point plain(point.x_size());
  for (int i = 0; i < point.x_size(); ++i) plain[i] = point.x(i);
  return plain;
}

}  // namespace

absl::StatusOr<Numerics> ToNumerics(const v1::Numerics& numerics) {
  Numerics result;
  if (numerics.has_tolerance()) result.tolerance = numerics.tolerance();
  switch (numerics.engine()) {
    case v1::ENGINE_UNSPECIFIED:
      return result;
    case v1::ENGINE_CVODE:
      result.engine = Engine::kCvode;
      return result;
    case v1::ENGINE_ARKODE:
      result.engine = Engine::kArkode;
      return result;
    case v1::ENGINE_FAST:
      result.engine = Engine::kFast;
      return result;
    default:
      return absl::InvalidArgumentError(
          absl::StrCat("engine: ", static_cast<int>(numerics.engine()), " is not known"));
  }
}

v1::Engine FromEngine(Engine engine) {
  switch (engine) {
    case Engine::kCvode:
      return v1::ENGINE_CVODE;
    case Engine::kArkode:
      return v1::ENGINE_ARKODE;
    case Engine::kFast:
      return v1::ENGINE_FAST;
    case Engine::kDefault:
      break;
  }
  return v1::ENGINE_UNSPECIFIED;
}

absl::StatusOr<Direction> ToDirection(v1::Direction direction) {
  switch (direction) {
    case v1::DIRECTION_UNSPECIFIED:
    case v1::DIRECTION_FORWARD:
      return Direction::kForward;
    case v1::DIRECTION_BACKWARD:
      return Direction::kBackward;
    default:
      return absl::InvalidArgumentError(
          absl::StrCat("direction: ", static_cast<int>(direction), " is not known"));
  }
}

v1::Direction FromDirection(Direction direction) {
  return direction == Direction::kForward ? v1::DIRECTION_FORWARD : v1::DIRECTION_BACKWARD;
}

Parameters ToParameters(const v1::System& system) {
  return {system.parameters().begin(), system.parameters().end()};
}

PointFrame::PointFrame(const v1::JobSpec& spec)
    : stone_(spec.system().name() == kStone), paper_(spec.frame() == v1::FRAME_PAPER) {
  if (stone_) delta_ = spec.system().parameters().at("delta");
}

/// The same formula both ways.
Point PointFrame::Exchange(const Point& point) const {
  if (!stone_ || !paper_) return point;
  return ExchangeFrame(SectionPoint(point), delta_);
}

absl::StatusOr<Point> PointFrame::ToPoint(const v1::Point& point) const {
  absl::StatusOr<Point> given = stone_ ? NamedCoordinates(point) : PlainCoordinates(point);
  if (!given.ok()) return given.status();
  return Exchange(*given);
}

v1::Point PointFrame::FromPoint(const Point& point) const {
  v1::Point result;
  if (!stone_) {
    result.mutable_x()->Add(point.begin(), point.end());
    return result;
  }
  const Point shown = Exchange(point);
  result.set_l(shown[0]);
  result.set_l_over_g(shown[1]);
  result.set_h_over_g(shown[2]);
  return result;
}

double PointFrame::FromG(double g) const { return paper_ ? WrapToTurn(g - std::numbers::pi) : g; }

}  // namespace celt::plans
