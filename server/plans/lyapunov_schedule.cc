#include "server/plans/lyapunov_schedule.h"

#include <algorithm>

namespace celt::plans {
namespace {

constexpr std::int64_t kRounds = 64;
constexpr std::int64_t kBatches = 4;  // of a block of orbits
constexpr std::int64_t kBlocks = 64;  // at most

std::int64_t CeilingOfRatio(std::int64_t a, std::int64_t b) { return (a + b - 1) / b; }

/// Up to the end of part `part` of `total` cut into `parts` parts as equal as can be:
/// ⌊total·part/parts⌋, written so that nothing overflows while parts² does not.
std::int64_t UpTo(std::int64_t total, std::int64_t part, std::int64_t parts) {
  return total / parts * part + total % parts * part / parts;
}

std::int64_t PartOf(std::int64_t total, std::int64_t part, std::int64_t parts) {
  return UpTo(total, part + 1, parts) - UpTo(total, part, parts);
}

/// As many rounds as there is something to tell, each batch made of equally many.
std::int64_t CountRounds(std::int64_t iterates_of_orbit) {
  if (iterates_of_orbit < kBatches) return iterates_of_orbit;
  return std::min(kRounds, iterates_of_orbit / kBatches * kBatches);
}

}  // namespace

LyapunovSchedule::LyapunovSchedule(std::int64_t iterates, std::int64_t orbits,
                                   std::int64_t transient, std::int64_t unit_iterates)
    : iterates_(iterates),
      orbits_(orbits),
      transient_(transient),
      transient_steps_(CeilingOfRatio(transient, unit_iterates)),
      rounds_(CountRounds(iterates / orbits)),
      measured_steps_(0) {
  const std::int64_t longest = CeilingOfRatio(CeilingOfRatio(iterates, orbits), rounds_);
  measured_steps_ = rounds_ * CeilingOfRatio(longest, unit_iterates);
}

std::int64_t LyapunovSchedule::Iterates(std::int64_t step, std::int64_t orbit) const {
  if (IsTransient(step)) return PartOf(transient_, step, transient_steps_);
  const std::int64_t total = iterates_ / orbits_ + (orbit < first_short_orbit() ? 1 : 0);
  return PartOf(total, step - transient_steps_, measured_steps_);
}

bool LyapunovSchedule::EndsRound(std::int64_t step) const {
  const std::int64_t done = step - transient_steps_ + 1;
  return done > 0 && done % (measured_steps_ / rounds_) == 0;
}

std::int64_t LyapunovSchedule::blocks() const { return std::min(orbits_, kBlocks); }

std::int64_t LyapunovSchedule::BlockOf(std::int64_t orbit) const {
  return orbit * blocks() / orbits_;
}

std::int64_t LyapunovSchedule::batches() const { return std::min(rounds_, kBatches); }

std::int64_t LyapunovSchedule::BatchOf(std::int64_t step) const {
  return (step - transient_steps_) / (measured_steps_ / batches());
}

std::int64_t LyapunovSchedule::BatchesComplete(std::int64_t step) const {
  return BatchOf(step + 1);
}

}  // namespace celt::plans
