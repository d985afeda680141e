#pragma once

#include <cstdint>
#include <limits>

#include "Eigen/Core"
#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "core/map/map.h"
#include "core/map/system.h"
#include "core/model/andoyer.h"
#include "core/model/celtic_stone.h"
#include "core/model/rolling.h"

namespace celt {

/// An orbit of the stone's flow under way: plain data, all that is needed to go on with it.
struct StoneOrbit {
  RollingState state;
  std::int64_t record = 0;  ///< number of the record that the state is
  double start_energy = 0;
  bool ended = false;  ///< nothing is left to do
};

/// Everything about the stone at an instant. Body axes unless said otherwise.
struct OrbitRecord {
  double time = 0;  ///< since the start; negative when going backward
  StoneState state;
  Eigen::Vector3d angular_velocity;  ///< ω [rad per unit of time]
  Eigen::Vector3d contact_on_body;   ///< r, from the centre of mass
  Eigen::Vector2d contact_on_plane;  ///< (X, Y), (0, 0) at the start; axes as of PlaceAtOrigin
  double heading = 0;  ///< angle from X to the horizontal part of body axis 1, in (−π, π] [rad]
  double spin_rate = 0;  ///< (ω, γ), about the vertical [rad per unit of time]
  double turns = 0;      ///< about the vertical since the start, ∫ (ω, γ) dt / 2π, signed
  Andoyer andoyer;       ///< angles mean nothing where |L| = G or |H| = G
  double energy = 0;
  double energy_drift = 0;  ///< energy less that at the start: conserved by the flow
  double gamma_drift = 0;   ///< |γ| − 1: conserved by the flow
};

/// What to record, and until when.
struct OrbitOptions {
  double step = 0.01;  ///< time from record to record, > 0
  double time = 10;    ///< the orbit's length, > 0; the last record is at this time exactly
  /// The orbit ends earlier, with the first record that is at least so many turns about the
  /// vertical, either way, from the start; > 0.
  double turns = std::numeric_limits<double>::infinity();
  Direction direction = Direction::kForward;
};

/// Starts an orbit. INVALID_ARGUMENT: M, γ or the energy is not finite, |γ| differs from 1 by more
/// than 10⁻⁶ (what differs less is normalised), or |γ₃| < kLeastGamma3.
absl::StatusOr<StoneOrbit> StartOrbit(const CelticStone& stone, const StoneState& state);

/// Called with each record; false stops the orbit there (CANCELLED).
using OrbitVisit = absl::FunctionRef<bool(const OrbitRecord& record)>;

/// Records what the orbit is now: at first, its start.
OrbitRecord RecordOf(const CelticStone& stone, const StoneOrbit& orbit,
                     const OrbitOptions& options);

/// Goes on for at most `records` records, until orbit.ended, visiting each; the start itself is not
/// visited. Every record is at the end of a step of the integrator's own: nothing is interpolated.
/// Each call starts the integrator anew, so that how an orbit is cut changes it by errors of the
/// order of the tolerance; kDefault is kArkode, as in AdvanceFlow.
///
/// INVALID_ARGUMENT: an option outside its range, more than 10⁹ records in all, an engine that does
/// not advance the flow between sections. OUT_OF_RANGE: the orbit was lost (γ₃ → 0), with time and
/// state; records up to there have been visited, and `orbit` is the last of them.
absl::Status AdvanceOrbit(const CelticStone& stone, StoneOrbit& orbit, const OrbitOptions& options,
                          const Numerics& numerics, std::int64_t records, OrbitVisit visit);

/// Number of records after the start, when no number of turns ends the orbit before. Status as of
/// AdvanceOrbit's options.
absl::StatusOr<std::int64_t> CountRecords(const OrbitOptions& options);

}  // namespace celt
