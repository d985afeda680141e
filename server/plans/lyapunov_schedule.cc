#include "server/plans/lyapunov_schedule.h"

#include <algorithm>

#include "absl/numeric/int128.h"

namespace celt::plans {
namespace {

constexpr std::int64_t kRounds = 64;       // at most
constexpr std::int64_t kFewestRounds = 8;  // where there are iterates enough
constexpr std::int64_t kRoundIterates =
    100;                                    // at least, of an orbit: shorter units are not worth it
constexpr std::int64_t kBatches = 16;       // at least, of all orbits together
constexpr std::int64_t kBlocks = 64;        // at most
constexpr std::int64_t kSample = 64;        // at most
constexpr std::int64_t kSampleShare = 250;  // iterates to a point of the sample

std::int64_t CeilingOfRatio(std::int64_t a, std::int64_t b) { return (a + b - 1) / b; }

/// Up to the end of part `part` of `total` cut into `parts` parts as equal as can be:
/// ⌊total·part/parts⌋. The product of the longest run and its units takes more than 64 bits.
std::int64_t UpTo(std::int64_t total, std::int64_t part, std::int64_t parts) {
  return static_cast<std::int64_t>(absl::int128(total) * part / parts);
}

std::int64_t PartOf(std::int64_t total, std::int64_t part, std::int64_t parts) {
  return UpTo(total, part + 1, parts) - UpTo(total, part, parts);
}

/// Batches of a block of orbits: a power of two, so that rounds can be a multiple of it.
std::int64_t CountBatches(std::int64_t orbits, std::int64_t iterates_of_orbit) {
  std::int64_t batches = 1;
  while (batches * orbits < kBatches && 2 * batches <= iterates_of_orbit) batches *= 2;
  return batches;
}

/// As many rounds as there is something to tell, each batch made of equally many.
std::int64_t CountRounds(std::int64_t iterates_of_orbit, std::int64_t batches) {
  const std::int64_t rounds = std::clamp(iterates_of_orbit / kRoundIterates,
                                         std::min(kFewestRounds, iterates_of_orbit), kRounds);
  return std::max(batches, rounds / batches * batches);
}

}  // namespace

LyapunovSchedule::LyapunovSchedule(std::int64_t iterates, std::int64_t orbits,
                                   std::int64_t transient, std::int64_t unit_iterates)
    : iterates_(iterates),
      orbits_(orbits),
      transient_(transient),
      transient_steps_(CeilingOfRatio(transient, unit_iterates)),
      batches_(CountBatches(orbits, iterates / orbits)),
      rounds_(CountRounds(iterates / orbits, batches_)),
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

std::int64_t LyapunovSchedule::BatchOf(std::int64_t step) const {
  return (step - transient_steps_) / (measured_steps_ / batches_);
}

bool LyapunovSchedule::IsSampled(std::int64_t step, std::int64_t orbit) const {
  const std::int64_t sample = std::clamp(iterates_ / kSampleShare, kSample / 8, kSample);
  const std::int64_t orbits = std::min(orbits_, sample);
  if (!EndsRound(step) || orbit >= orbits) return false;
  const std::int64_t round = (step - transient_steps_) / (measured_steps_ / rounds_);
  return (round + orbit) % std::max<std::int64_t>(rounds_ * orbits / sample, 1) == 0;
}

}  // namespace celt::plans
