#include "core/analysis/orbit.h"

#include <cmath>
#include <memory>
#include <numbers>

#include "Eigen/Geometry"
#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "core/integrate/flow_stepper.h"
#include "core/integrate/ode_stepper.h"
#include "core/integrate/rolling_problem.h"

namespace celt {
namespace {

constexpr double kMostRecords = 1e9;
constexpr int kMostSteps = 1'000'000;  // between two records

absl::Status CheckPositive(const char* name, double value) {
  if (value > 0) return absl::OkStatus();
  return absl::InvalidArgumentError(
      absl::StrCat(name, ": ", value, " is not allowed; must be positive"));
}

/// Time of record `record` since the start, without sign.
double TimeOf(std::int64_t record, const OrbitOptions& options) {
  return std::min(static_cast<double>(record) * options.step, options.time);
}

double Sign(const OrbitOptions& options) {
  return options.direction == Direction::kForward ? 1 : -1;
}

absl::Status Lost(double time, std::span<const double> y, absl::string_view why) {
  return absl::OutOfRangeError(absl::StrCat("orbit lost at t = ", time, ", M = (", y[0], ", ", y[1],
                                            ", ", y[2], "), gamma = (", y[3], ", ", y[4], ", ",
                                            y[5], "): ", why));
}

absl::Status StepTo(OdeStepper& stepper, double stop, double start_time) {
  for (int step = 0; stepper.time() != stop; ++step) {
    const double time = start_time + stepper.time();
    if (step == kMostSteps) return Lost(time, stepper.state(), "it takes too many steps");
    if (const absl::Status status = stepper.Step(stop); !status.ok()) {
      return Lost(time, stepper.state(), status.message());
    }
    if (!(std::abs(stepper.state()[5]) >= kLeastGamma3)) {
      return Lost(start_time + stepper.time(), stepper.state(), "gamma3 has come to 0");
    }
  }
  return absl::OkStatus();
}

bool IsLast(const StoneOrbit& orbit, const OrbitOptions& options) {
  const double turns = std::abs(orbit.state.spin) / (2 * std::numbers::pi);
  return TimeOf(orbit.record, options) == options.time || turns >= options.turns;
}

}  // namespace

absl::StatusOr<StoneOrbit> StartOrbit(const CelticStone& stone, const StoneState& state) {
  constexpr double kSlack = 1e-6;
  const double norm = state.tail<3>().norm();
  if (!state.allFinite()) return absl::InvalidArgumentError("state: must be finite");
  if (std::abs(norm - 1) > kSlack) {
    return absl::InvalidArgumentError(
        absl::StrCat("gamma: |gamma| = ", norm, " is not allowed; must be 1 to within ", kSlack));
  }
  StoneState start = state;
  start.tail<3>() /= norm;
  if (std::abs(start[5]) < kLeastGamma3) {
    return absl::InvalidArgumentError(absl::StrCat(
        "gamma: gamma3 = ", start[5], " is not allowed; |gamma3| must be at least ", kLeastGamma3));
  }
  const double energy = stone.Energy(start);
  if (!std::isfinite(energy)) {
    return absl::InvalidArgumentError("M: is too large; the energy must be finite");
  }
  return StoneOrbit{
      .state = PlaceAtOrigin(start), .record = 0, .start_energy = energy, .ended = false};
}

absl::StatusOr<std::int64_t> CountRecords(const OrbitOptions& options) {
  absl::Status status = CheckPositive("step", options.step);
  status.Update(CheckPositive("time", options.time));
  status.Update(CheckPositive("turns", options.turns));
  if (!status.ok()) return status;
  const double records = std::ceil(options.time / options.step);
  if (!(records <= kMostRecords)) {
    return absl::InvalidArgumentError(absl::StrCat("time: ", options.time, " with step ",
                                                   options.step, " is not allowed; at most ",
                                                   kMostRecords, " records"));
  }
  return static_cast<std::int64_t>(records);
}

OrbitRecord RecordOf(const CelticStone& stone, const StoneOrbit& orbit,
                     const OrbitOptions& options) {
  const RollingState& now = orbit.state;
  const Eigen::Vector3d gamma = now.stone.tail<3>();
  const Eigen::Vector3d across = gamma.cross(now.heading);  // the Y axis
  const Eigen::Vector3d omega = stone.AngularVelocity(now.stone);
  const double energy = stone.Energy(now.stone);
  return {.time = Sign(options) * TimeOf(orbit.record, options),
          .state = now.stone,
          .angular_velocity = omega,
          .contact_on_body = stone.ContactPoint(gamma),
          .contact_on_plane = now.contact,
          .heading = std::atan2(across.x(), now.heading.x()),
          .spin_rate = omega.dot(gamma),
          .turns = now.spin / (2 * std::numbers::pi),
          .andoyer = ToAndoyer(now.stone),
          .energy = energy,
          .energy_drift = energy - orbit.start_energy,
          .gamma_drift = gamma.norm() - 1};
}

absl::Status AdvanceOrbit(const CelticStone& stone, StoneOrbit& orbit, const OrbitOptions& options,
                          const Numerics& numerics, std::int64_t records, OrbitVisit visit) {
  if (const auto count = CountRecords(options); !count.ok()) return count.status();
  if (absl::Status status = CheckNumerics(numerics); !status.ok()) return status;
  const RollingProblem problem(stone, numerics.tolerance);
  const std::vector<double> start = Pack(orbit.state);
  auto stepper = MakeFlowStepper(numerics.engine, problem, start);
  if (!stepper.ok()) return stepper.status();
  const double start_time = TimeOf(orbit.record, options);
  for (std::int64_t i = 0; i < records && !orbit.ended; ++i) {
    const double stop = Sign(options) * (TimeOf(orbit.record + 1, options) - start_time);
    absl::Status status = StepTo(**stepper, stop, Sign(options) * start_time);
    if (!status.ok()) return status;
    orbit.state = UnpackRolling((*stepper)->state());
    ++orbit.record;
    orbit.ended = IsLast(orbit, options);
    if (!visit(RecordOf(stone, orbit, options))) {
      return absl::CancelledError("stopped before the orbit was done");
    }
  }
  return absl::OkStatus();
}

}  // namespace celt
