#pragma once

#include <cstdint>

namespace celt::plans {

/// The most iterates of a job; the schedule's arithmetic is exact up to here.
inline constexpr std::int64_t kMaxIterates = 1'000'000'000'000;

/// Which iterates of which orbit each step of a Lyapunov job does: arithmetic alone. First come the
/// transient's steps, then those that are measured, in rounds of equally many. A round ends with a
/// record. An orbit's rounds make up a batch for the standard errors, or several where there are
/// fewer than 16 orbits; the orbits make up blocks, so that there are never many batches. On the
/// way orbits leave points behind, up to 64, evenly over orbits and rounds: a sample of the
/// attractor. None of this depends on how orbits are grouped into chains.
class LyapunovSchedule {
 public:
  /// `unit_iterates`: the most iterates of an orbit in a step. Precondition: all positive
  /// (transient: or 0), orbits ≤ iterates ≤ kMaxIterates.
  LyapunovSchedule(std::int64_t iterates, std::int64_t orbits, std::int64_t transient,
                   std::int64_t unit_iterates);

  std::int64_t steps() const { return transient_steps_ + measured_steps_; }
  bool IsTransient(std::int64_t step) const { return step < transient_steps_; }
  /// Of an orbit, in a step. Orbits of one kind (before first_short_orbit, or from there on) do
  /// equally many.
  std::int64_t Iterates(std::int64_t step, std::int64_t orbit) const;
  /// Orbits from here on are measured over one iterate less than those before.
  std::int64_t first_short_orbit() const { return iterates_ % orbits_; }

  bool EndsRound(std::int64_t step) const;
  std::int64_t blocks() const;
  std::int64_t BlockOf(std::int64_t orbit) const;
  /// Batches of a block, one after the other.
  std::int64_t batches() const { return batches_; }
  /// Of a block, to which a measured step belongs.
  std::int64_t BatchOf(std::int64_t step) const;
  /// Whether where an orbit stands after a step belongs to the sample.
  bool IsSampled(std::int64_t step, std::int64_t orbit) const;

 private:
  std::int64_t iterates_;
  std::int64_t orbits_;
  std::int64_t transient_;
  std::int64_t transient_steps_;
  std::int64_t batches_;
  std::int64_t rounds_;
  std::int64_t measured_steps_;
};

}  // namespace celt::plans
