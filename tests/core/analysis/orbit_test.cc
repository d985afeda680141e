#include "core/analysis/orbit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "Eigen/Geometry"
#include "gtest/gtest.h"

namespace celt {
namespace {

constexpr std::int64_t kAll = 1'000'000'000;
const CelticStone kStone{StoneParameters{}};

/// O* at E = 752, and its return time (tests/reference/celtic_stone.json).
const SectionPoint kFixedPoint(2.147462384985, -0.669144118368, -0.384701258034);
constexpr double kReturnTime = 0.792136027186;

StoneOrbit OnTheSection(const SectionPoint& x) {
  const auto lifted = LiftToLevel(kStone, 752, std::numbers::pi, x);
  EXPECT_TRUE(lifted.ok()) << lifted.status();
  return StartOrbit(kStone, lifted->state).value();
}

/// Turning about the vertical at `rate`, its own axis off the vertical by about `tilt` [rad]
/// towards both of the geometric axes.
StoneOrbit Spinning(double rate, double tilt) {
  const Eigen::Vector3d gamma = Eigen::Vector3d(tilt, tilt, 1).normalized();
  StoneState state;
  state << kStone.ContactInertia(gamma) * Eigen::Vector3d(0, 0, rate), gamma;
  return StartOrbit(kStone, state).value();
}

std::vector<OrbitRecord> Record(StoneOrbit& orbit, const OrbitOptions& options,
                                std::int64_t records = kAll) {
  std::vector<OrbitRecord> all;
  const absl::Status status =
      AdvanceOrbit(kStone, orbit, options, {}, records, [&all](const OrbitRecord& record) {
        all.push_back(record);
        return true;
      });
  EXPECT_TRUE(status.ok()) << status;
  return all;
}

TEST(Orbit, OfTheFixedPointClosesAfterItsReturnTime) {
  StoneOrbit orbit = OnTheSection(kFixedPoint);
  const OrbitRecord start = RecordOf(kStone, orbit, {});
  const auto records = Record(orbit, {.step = 0.1, .time = kReturnTime});
  ASSERT_EQ(records.size(), 8U);
  EXPECT_EQ(records.back().time, kReturnTime);
  // The point is given to 1e-12, times |M| of about 60 and the derivative of the flow; the
  // integrator's errors are 1e-11 a step.
  EXPECT_LT((records.back().state - start.state).norm(), 1e-8);
  EXPECT_NEAR(start.andoyer.g, std::numbers::pi, 1e-12);
  EXPECT_NEAR(start.andoyer.L / start.andoyer.G, kFixedPoint[1], 1e-14);
  EXPECT_NEAR(start.energy, 752, 1e-10);
}

TEST(Orbit, ConservesEnergyAndTheLengthOfGamma) {
  StoneOrbit orbit = OnTheSection(kFixedPoint + SectionPoint(0.01, 0.01, 0.01));
  for (const OrbitRecord& record : Record(orbit, {.step = 0.5, .time = 50})) {
    // Some 30 steps a unit of time, each with a relative error of 1e-11 that may have one sign.
    EXPECT_LT(std::abs(record.energy_drift), 50 * 30 * 1e-11 * 752);
    EXPECT_LT(std::abs(record.gamma_drift), 50 * 30 * 1e-11);
    EXPECT_EQ(record.energy_drift, record.energy - orbit.start_energy);
  }
}

TEST(Orbit, BackwardRetracesItsTrack) {
  StoneOrbit orbit = OnTheSection(kFixedPoint + SectionPoint(0.01, 0, 0));
  const OrbitRecord start = RecordOf(kStone, orbit, {});
  Record(orbit, {.step = 0.1, .time = 2});
  orbit.record = 0;
  orbit.ended = false;
  const auto back = Record(orbit, {.step = 0.1, .time = 2, .direction = Direction::kBackward});
  EXPECT_EQ(back.back().time, -2);
  EXPECT_LT((back.back().state - start.state).norm(), 1e-7);
  EXPECT_LT(back.back().contact_on_plane.norm(), 1e-7);
  EXPECT_NEAR(back.back().turns, 0, 1e-8);
}

/// In the axes of the plane: columns X, Y, Z in body axes, transposed.
Eigen::Matrix3d ToSpace(const OrbitRecord& record) {
  const Eigen::Vector3d gamma = record.state.tail<3>();
  const Eigen::Vector3d first = Eigen::Vector3d::UnitX() - gamma.x() * gamma;
  Eigen::Matrix3d body_to_level;
  body_to_level.row(0) = first.normalized();
  body_to_level.row(1) = gamma.cross(first.normalized());
  body_to_level.row(2) = gamma;
  return Eigen::AngleAxisd(record.heading, Eigen::Vector3d::UnitZ()) * body_to_level;
}

TEST(Orbit, StoneRollsWithoutSlipping) {
  const double step = 1e-3;
  StoneOrbit orbit = OnTheSection(kFixedPoint);
  const auto records = Record(orbit, {.step = step, .time = 1});
  const auto centre = [](const OrbitRecord& record) -> Eigen::Vector2d {
    return record.contact_on_plane - (ToSpace(record) * record.contact_on_body).head<2>();
  };
  for (std::size_t i = 1; i + 1 < records.size(); i += 50) {
    const Eigen::Vector2d velocity = (centre(records[i + 1]) - centre(records[i - 1])) / (2 * step);
    // The body's point at the contact is at rest: the centre of mass has velocity −ω×r.
    const Eigen::Vector3d rolling =
        ToSpace(records[i]) * records[i].contact_on_body.cross(records[i].angular_velocity);
    // Central differences: step²/6 times a third derivative of 15 · (10/time)³.
    EXPECT_LT((velocity - rolling.head<2>()).norm(), 5e-3);
  }
}

TEST(Orbit, StoneReversesItsSpin) {
  // Spun the wrong way, at 2 about the vertical, it begins to rock, stands still, and ends up
  // spinning the other way about as fast. Spun the other way it goes on for longer than this.
  StoneOrbit orbit = Spinning(-2, 0.01);
  const auto records = Record(orbit, {.step = 0.05, .time = 12});
  EXPECT_NEAR(RecordOf(kStone, Spinning(-2, 0.01), {}).spin_rate, -2, 1e-3);
  EXPECT_GT(records.back().spin_rate, 1.9);
  EXPECT_GT(records.back().turns, records[records.size() / 2].turns);
  // The height of the centre of mass above that of rest, times m g = 100.
  const auto lift = [](const OrbitRecord& record) {
    return -100 * (record.contact_on_body.dot(record.state.tail<3>()) + 1);
  };
  const auto highest = std::max_element(
      records.begin(), records.end(),
      [&](const OrbitRecord& a, const OrbitRecord& b) { return lift(a) < lift(b); });
  const double energy = highest->energy - 100;
  EXPECT_NEAR(energy, 0.5 * 7 * 4, 0.1) << "all of it in the spin at first";
  EXPECT_GT(lift(*highest), 0.95 * energy) << "and all of it in the rocking in between";
  EXPECT_LT(std::abs(highest->spin_rate), 0.1);
  StoneOrbit right = Spinning(2, 0.01);
  EXPECT_GT(Record(right, {.step = 0.05, .time = 6}).back().spin_rate, 1.5);
}

TEST(Orbit, EndsAfterAskedForTurns) {
  StoneOrbit orbit = Spinning(5, 0.01);
  const auto records = Record(orbit, {.step = 0.01, .time = 100, .turns = 2});
  EXPECT_TRUE(orbit.ended);
  EXPECT_GE(records.back().turns, 2);
  EXPECT_LT(records[records.size() - 2].turns, 2);
  EXPECT_NEAR(records.back().time, 2 * 2 * std::numbers::pi / 5, 0.1);
}

TEST(Orbit, PiecesAgreeWithTheWholeToTheTolerance) {
  const OrbitOptions options = {.step = 0.1, .time = 3};
  StoneOrbit whole = OnTheSection(kFixedPoint);
  StoneOrbit cut = whole;
  const auto records = Record(whole, options);
  auto pieces = Record(cut, options, 7);
  EXPECT_EQ(pieces.size(), 7U);
  EXPECT_FALSE(cut.ended);
  for (const OrbitRecord& record : Record(cut, options)) pieces.push_back(record);
  ASSERT_EQ(pieces.size(), records.size());
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(pieces[i].time, records[i].time);
    EXPECT_LT((pieces[i].state - records[i].state).norm(), 1e-7);
  }
}

TEST(Orbit, BadOptionsAndStartsAreRefused) {
  const auto refused = [](const OrbitOptions& options) {
    StoneOrbit orbit = Spinning(1, 0.01);
    const auto ignore = [](const OrbitRecord&) { return true; };
    return AdvanceOrbit(kStone, orbit, options, {}, 1, ignore).code() ==
           absl::StatusCode::kInvalidArgument;
  };
  EXPECT_TRUE(refused({.step = 0}));
  EXPECT_TRUE(refused({.step = std::nan("")}));
  EXPECT_TRUE(refused({.time = -1}));
  EXPECT_TRUE(refused({.turns = 0}));
  EXPECT_TRUE(refused({.step = 1e-9, .time = 1e9}));
  StoneState state = StoneState::Zero();
  EXPECT_FALSE(StartOrbit(kStone, state).ok()) << "gamma of length 0";
  state << 1, 0, 0, 1, 0, 0;
  EXPECT_FALSE(StartOrbit(kStone, state).ok()) << "gamma3 = 0";
  state[0] = std::nan("");
  EXPECT_FALSE(StartOrbit(kStone, state).ok());
  state << 1e200, 0, 0, 0, 0, 1;
  EXPECT_FALSE(StartOrbit(kStone, state).ok()) << "an energy that is not finite";
}

TEST(Orbit, StopsWhenTold) {
  StoneOrbit orbit = Spinning(1, 0.01);
  const absl::Status status = AdvanceOrbit(
      kStone, orbit, {}, {}, kAll, [](const OrbitRecord& record) { return record.time < 0.045; });
  EXPECT_EQ(status.code(), absl::StatusCode::kCancelled);
  EXPECT_EQ(orbit.record, 5);
}

}  // namespace
}  // namespace celt
