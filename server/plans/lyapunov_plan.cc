#include "server/plans/lyapunov_plan.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/lyapunov_answer.h"
#include "server/plans/lyapunov_spec.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

constexpr std::int64_t kGroup = 8;

/// Iterates of all orbits of a unit, about a second's worth: an iterate takes some 2 ms by
/// SUNDIALS, 10 μs by the fast engine, less by a formula. A matter of the specification alone,
/// never of a measured time, for the cuts show in the last bits of the sums.
std::int64_t UnitBudget(const v1::JobSpec& spec) {
  const v1::Engine engine = spec.numerics().engine();
  return engine == v1::ENGINE_CVODE || engine == v1::ENGINE_ARKODE ? 500 : 100'000;
}

std::int64_t DefaultGroup(std::int64_t orbits) { return std::min(kGroup, orbits); }

LyapunovSchedule MakeSchedule(const v1::JobSpec& spec) {
  const v1::LyapunovSpec& lyapunov = spec.lyapunov();
  const std::int64_t unit = UnitBudget(spec) / DefaultGroup(lyapunov.orbits());
  return {lyapunov.iterates(), lyapunov.orbits(), lyapunov.transient(), unit};
}

std::vector<LyapunovSums> WithoutEmpty(std::span<const LyapunovSums> batches) {
  std::vector<LyapunovSums> result;
  for (const LyapunovSums& batch : batches) {
    if (batch.iterates > 0) result.push_back(batch);
  }
  return result;
}

}  // namespace

absl::StatusOr<std::unique_ptr<LyapunovPlan>> LyapunovPlan::Make(const v1::JobSpec& resolved,
                                                                 std::int64_t group_size) {
  CELT_ASSIGN_OR_RETURN(std::unique_ptr<Map> map, MakeMap(resolved));
  if (group_size == 0) group_size = DefaultGroup(resolved.lyapunov().orbits());
  return std::unique_ptr<LyapunovPlan>(new LyapunovPlan(resolved, std::move(map), group_size));
}

LyapunovPlan::LyapunovPlan(const v1::JobSpec& resolved, std::unique_ptr<Map> map,
                           std::int64_t group_size)
    : spec_(resolved),
      map_(std::move(map)),
      orbits_(resolved.lyapunov().orbits()),
      group_size_(group_size),
      schedule_(MakeSchedule(resolved)) {}

std::int64_t LyapunovPlan::chains() const { return (orbits_ + group_size_ - 1) / group_size_; }

std::int64_t LyapunovPlan::EndOrbit(std::int64_t chain) const {
  return std::min(orbits_, FirstOrbit(chain + 1));
}

jobs::Work LyapunovPlan::work() const {
  const v1::LyapunovSpec& lyapunov = spec_.lyapunov();
  const std::int64_t total = lyapunov.iterates() + orbits_ * lyapunov.transient();
  return {.total = static_cast<double>(total), .unit = "iterates"};
}

absl::StatusOr<std::vector<FramedOrbit>> LyapunovPlan::Starts(std::int64_t chain) const {
  CELT_ASSIGN_OR_RETURN(const std::vector<FramedOrbit> all, LyapunovStarts(spec_));
  return std::vector<FramedOrbit>(all.begin() + FirstOrbit(chain), all.begin() + EndOrbit(chain));
}

/// Orbits that do equally many iterates go together: each orbit's sums are then one stretch,
/// however it is grouped.
absl::StatusOr<std::vector<LyapunovSums>> LyapunovPlan::Advance(
    jobs::UnitId unit, std::vector<FramedOrbit>& orbits, const jobs::StopRequested& stop) const {
  const std::int64_t first = FirstOrbit(unit.chain);
  const std::int64_t end = first + std::ssize(orbits);
  const std::int64_t split = std::clamp(schedule_.first_short_orbit(), first, end);
  std::vector<LyapunovSums> sums;
  for (const auto& [from, to] : {std::pair(first, split), std::pair(split, end)}) {
    if (from == to) continue;
    CELT_ASSIGN_OR_RETURN(
        const std::vector<LyapunovSums> part,
        AdvanceFrames(*map_, std::span(orbits).subspan(from - first, to - from),
                      schedule_.Iterates(unit.step, from), [&](std::int64_t) { return !stop(); }));
    sums.insert(sums.end(), part.begin(), part.end());
  }
  return sums;
}

absl::StatusOr<jobs::UnitOutput> LyapunovPlan::Run(jobs::UnitId unit, std::string_view checkpoint,
                                                   const jobs::StopRequested& stop) const {
  CELT_ASSIGN_OR_RETURN(std::vector<FramedOrbit> orbits,
                        unit.step == 0 ? Starts(unit.chain) : DecodeOrbits(checkpoint));
  if (std::ssize(orbits) != EndOrbit(unit.chain) - FirstOrbit(unit.chain)) {
    return absl::DataLossError("the stored state of the job is of another number of orbits");
  }
  CELT_ASSIGN_OR_RETURN(const std::vector<LyapunovSums> sums, Advance(unit, orbits, stop));
  jobs::UnitOutput output;
  for (const LyapunovSums& sum : sums) output.work += static_cast<double>(sum.iterates);
  if (!schedule_.IsTransient(unit.step)) output.payload = EncodeTally(Tally(unit, sums, orbits));
  output.checkpoint = EncodeOrbits(orbits);
  return output;
}

LyapunovTally LyapunovPlan::Tally(jobs::UnitId unit, std::vector<LyapunovSums> sums,
                                  const std::vector<FramedOrbit>& orbits) const {
  LyapunovTally tally;
  tally.sums = std::move(sums);
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    if (schedule_.IsSampled(unit.step, FirstOrbit(unit.chain) + static_cast<std::int64_t>(i)))
      tally.sample.push_back(orbits[i]);
  }
  return tally;
}

absl::StatusOr<jobs::Collected> LyapunovPlan::Collect(jobs::UnitId unit, std::string_view state,
                                                      std::string_view payload) const {
  if (schedule_.IsTransient(unit.step)) return jobs::Collected{std::string(state), {}};
  CELT_ASSIGN_OR_RETURN(LyapunovTally all, DecodeTally(state));
  CELT_ASSIGN_OR_RETURN(const LyapunovTally part, DecodeTally(payload));
  // Batch after batch, and the blocks in each.
  all.sums.resize(schedule_.blocks() * schedule_.batches());
  std::int64_t orbit = FirstOrbit(unit.chain);
  for (const LyapunovSums& sums : part.sums) {
    all.sums[schedule_.BatchOf(unit.step) * schedule_.blocks() + schedule_.BlockOf(orbit)] += sums;
    ++orbit;
  }
  all.sample.insert(all.sample.end(), part.sample.begin(), part.sample.end());
  jobs::Collected collected;
  collected.state = EncodeTally(all);
  if (unit.chain + 1 == chains() && schedule_.EndsRound(unit.step)) {
    v1::Record record;
    *record.mutable_lyapunov() = ToRecord(WithoutEmpty(all.sums));
    collected.records.push_back(Serialize(record));
  }
  return collected;
}

absl::StatusOr<std::string> LyapunovPlan::Finish(std::string_view state) const {
  CELT_ASSIGN_OR_RETURN(const LyapunovTally all, DecodeTally(state));
  v1::Result result;
  *result.mutable_lyapunov() = ToResult(all.sums, static_cast<int>(orbits_));
  CELT_RETURN_IF_ERROR(AddAccuracy(spec_, *map_, all.sample, *result.mutable_lyapunov()));
  return Serialize(result);
}

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeLyapunovPlan(const v1::JobSpec& resolved) {
  return LyapunovPlan::Make(resolved);
}

}  // namespace celt::plans
