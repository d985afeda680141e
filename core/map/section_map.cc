#include "core/map/section_map.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>
#include <numbers>
#include <utility>

#include "absl/strings/str_cat.h"
#include "core/model/angle.h"

namespace celt {

/// Orbits as a supply of crossings to compute: the next of an orbit is ready when the one before is
/// done.
class SectionMap::OrbitFeed final : public CrossingFeed {
 public:
  OrbitFeed(const SectionMap& map, std::span<const Point> starts, const Advance& advance,
            Visit visit)
      : map_(map), advance_(advance), visit_(visit), orbits_(starts.size()) {
    for (std::size_t i = 0; i < starts.size(); ++i) {
      orbits_[i].point = starts[i];
      if (advance.iterates > 0) ready_.push_back(static_cast<int>(i));
    }
  }

  bool Next(CrossingTask& task, int& ticket) override {
    while (!ready_.empty()) {
      ticket = ready_.front();
      ready_.pop_front();
      if (Prepare(orbits_[ticket], task)) return true;
    }
    return false;
  }

  void Done(int ticket, const absl::Status& status, const Crossing& crossing) override {
    Orbit& orbit = orbits_[ticket];
    orbit.status = status;
    if (status.ok()) Arrive(ticket, crossing);
  }

  std::vector<absl::Status> statuses() const {
    std::vector<absl::Status> statuses;
    for (const Orbit& orbit : orbits_) statuses.push_back(orbit.status);
    return statuses;
  }

 private:
  struct Orbit {
    Point point;
    std::int64_t done = 0;
    absl::Status status;
  };

  bool Prepare(Orbit& orbit, CrossingTask& task) const {
    const auto lifted = map_.Lift(orbit.point);
    if (!lifted.ok()) {
      orbit.status = orbit.done == 0 ? lifted.status() : LostAfter(orbit, lifted.status());
      return false;
    }
    task.state = lifted->state;
    task.tangents = lifted->derivative;
    return true;
  }

  /// An image that cannot be lifted is not the caller's mistake.
  static absl::Status LostAfter(const Orbit& orbit, const absl::Status& status) {
    return absl::OutOfRangeError(
        absl::StrCat("orbit lost after ", orbit.done, " iterates: ", status.message()));
  }

  void Arrive(int ticket, const Crossing& crossing) {
    Orbit& orbit = orbits_[ticket];
    const auto image = map_.ToImage(crossing, advance_.derivative);
    orbit.status = image.status();
    if (!image.ok()) return;
    orbit.point = image->point;
    ++orbit.done;
    if (visit_(ticket, *image) && orbit.done < advance_.iterates) ready_.push_back(ticket);
  }

  const SectionMap& map_;
  Advance advance_;
  Visit visit_;
  std::vector<Orbit> orbits_;
  std::deque<int> ready_;
};

SectionMap::SectionMap(const CelticStone& stone, double energy, double section_angle,
                       std::unique_ptr<const SectionEngine> engine)
    : stone_(stone),
      energy_(energy),
      section_angle_(section_angle),
      event_(section_angle),
      engine_(std::move(engine)) {
  assert(engine_ != nullptr);
}

absl::StatusOr<Image> SectionMap::Apply(const Point& x, Direction direction,
                                        Derivative derivative) const {
  Image result;
  const auto keep = [&result](int, const Image& image) {
    result = image;
    return false;
  };
  OrbitFeed feed(*this, {&x, 1}, {.iterates = 1, .direction = direction, .derivative = derivative},
                 keep);
  engine_->Run(feed, direction, derivative);
  if (absl::Status status = feed.statuses().front(); !status.ok()) return status;
  return result;
}

std::vector<absl::Status> SectionMap::AdvanceAll(std::span<const Point> starts,
                                                 const Advance& advance, Visit visit) const {
  OrbitFeed feed(*this, starts, advance, visit);
  engine_->Run(feed, advance.direction, advance.derivative);
  return feed.statuses();
}

Point SectionMap::Difference(const Point& a, const Point& b) const {
  Point difference = a - b;
  difference[0] = WrapToHalfTurns(difference[0]);
  return difference;
}

std::vector<Symmetry> SectionMap::Symmetries() const {
  const auto symmetry = [](double turn, double sign) {
    return Symmetry{.apply = [turn, sign](const Point& x) -> Point {
                      return Eigen::Vector3d(WrapToTurn(x[0] + turn), sign * x[1], sign * x[2]);
                    },
                    .reverses_time = sign < 0};
  };
  constexpr double kHalfTurn = std::numbers::pi;
  std::vector<Symmetry> symmetries = {symmetry(kHalfTurn, 1)};
  // M → −M takes g to −g: the section stays in place where the two differ by whole turns.
  constexpr double kSameAngle = 1e-12;
  if (std::abs(WrapToHalfTurns(2 * section_angle_)) < kSameAngle) {
    symmetries.push_back(symmetry(kHalfTurn, -1));
    symmetries.push_back(symmetry(0, -1));
  }
  return symmetries;
}

absl::Status SectionMap::CheckPoint(const Point& x) const { return Lift(x).status(); }

absl::StatusOr<LiftedPoint> SectionMap::Lift(const Point& x) const {
  if (x.size() != dimension()) {
    return absl::InvalidArgumentError(
        absl::StrCat("start: has ", x.size(), " coordinates; must have 3"));
  }
  return LiftToLevel(stone_, energy_, section_angle_, SectionPoint(x));
}

double SectionMap::Drift(const StoneState& state) const {
  const double potential = stone_.Potential(state.tail<3>());
  const double energy = stone_.Energy(state);
  const double size = std::abs(energy - potential) + std::abs(potential);
  return std::max(std::abs(energy - energy_) / size, std::abs(state.tail<3>().norm() - 1));
}

absl::StatusOr<Image> SectionMap::ToImage(const Crossing& crossing, Derivative derivative) const {
  const ProjectedState projected = ProjectToSection(crossing.state);
  Image image{.point = projected.x,
              .time = crossing.time,
              .jacobian = SquareMatrix(),
              .drift = Drift(crossing.state)};
  if (derivative == Derivative::kJacobian) {
    const StoneState normal = event_.Gradient(crossing.state);
    const Eigen::RowVector3d delays =
        normal.transpose() * crossing.tangents / normal.dot(crossing.velocity);
    image.jacobian = projected.derivative * (crossing.tangents - crossing.velocity * delays);
  }
  if (!image.point.allFinite() || !image.jacobian.allFinite()) {
    return absl::OutOfRangeError(
        absl::StrCat("orbit lost at t = ", crossing.time,
                     ": section coordinates are undefined at the crossing, |L/G| = 1"));
  }
  return image;
}

}  // namespace celt
