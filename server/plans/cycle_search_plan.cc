#include "server/plans/cycle_search_plan.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "server/jobs/status_macros.h"
#include "server/plans/accuracy.h"
#include "server/plans/convert_cycle.h"
#include "server/plans/cycle_state.h"
#include "server/plans/fixed_point_spec.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

constexpr std::int64_t kMostChains = 64;
/// Points of all starts of a unit: Newton's method takes some ten images of each, 20 μs an image.
constexpr std::int64_t kMostPoints = 1000;
/// Points of all cycles in the result, which is one message of less than 4 MiB.
constexpr std::int64_t kMostResultPoints = 20'000;

/// Small enough that a short search still occupies several cores. A matter of the specification
/// alone.
std::int64_t BlockSize(const v1::FixedPointSpec& spec) {
  return std::clamp<std::int64_t>(spec.search() / kMostChains, 1,
                                  std::max<std::int64_t>(1, kMostPoints / spec.period()));
}

v1::SearchTally FromTally(const CycleSearchTally& tally) {
  v1::SearchTally out;
  out.set_starts(tally.starts);
  out.set_found(tally.found);
  out.set_shorter(tally.shorter);
  out.set_no_convergence(tally.no_convergence);
  out.set_left_domain(tally.left_domain);
  out.set_singular(tally.singular);
  out.set_outside(tally.outside);
  return out;
}

}  // namespace

absl::StatusOr<std::unique_ptr<jobs::Plan>> CycleSearchPlan::Make(const v1::JobSpec& resolved) {
  CELT_ASSIGN_OR_RETURN(std::unique_ptr<Map> map, MakeMap(resolved));
  CELT_ASSIGN_OR_RETURN(CycleSearchOptions options, SearchOf(resolved));
  CELT_RETURN_IF_ERROR(CheckCycleSearch(*map, options));
  return std::unique_ptr<jobs::Plan>(
      new CycleSearchPlan(resolved, std::move(map), std::move(options)));
}

CycleSearchPlan::CycleSearchPlan(const v1::JobSpec& resolved, std::unique_ptr<Map> map,
                                 CycleSearchOptions options)
    : spec_(resolved),
      frame_(resolved),
      map_(std::move(map)),
      options_(std::move(options)),
      starts_(resolved.fixed_point().search()),
      block_(BlockSize(resolved.fixed_point())) {}

std::int64_t CycleSearchPlan::chains() const { return std::min(kMostChains, blocks()); }

std::int64_t CycleSearchPlan::steps() const { return (blocks() + chains() - 1) / chains(); }

jobs::Work CycleSearchPlan::work() const {
  return {.total = static_cast<double>(starts_), .unit = "starts"};
}

absl::StatusOr<jobs::UnitOutput> CycleSearchPlan::Run(jobs::UnitId unit, std::string_view,
                                                      const jobs::StopRequested& stop) const {
  const std::int64_t first = BlockOf(unit) * block_;
  const std::int64_t last = std::min(starts_, first + block_);
  CELT_ASSIGN_OR_RETURN(const CycleSearchState found,
                        SearchCycles(*map_, options_, first, last, [&] { return !stop(); }));
  jobs::UnitOutput output;
  output.payload = EncodeSearch(found);
  output.work = static_cast<double>(last - first);
  output.chain_ended = BlockOf(unit) + chains() >= blocks();
  return output;
}

absl::StatusOr<jobs::Collected> CycleSearchPlan::Collect(jobs::UnitId unit, std::string_view state,
                                                         std::string_view payload) const {
  CELT_ASSIGN_OR_RETURN(CycleSearchState known, DecodeSearch(state));
  CELT_ASSIGN_OR_RETURN(const CycleSearchState later, DecodeSearch(payload));
  const std::ptrdiff_t before = std::ssize(known.cycles);
  Merge(*map_, options_, later, known);
  if (BlockOf(unit) + 1 == blocks()) AddMirrors(*map_, options_, known);
  jobs::Collected collected;
  collected.state = EncodeSearch(known);
  std::transform(known.cycles.begin() + before, known.cycles.end(),
                 std::back_inserter(collected.records),
                 [this](const FoundCycle& found) { return Record(found); });
  return collected;
}

std::string CycleSearchPlan::Record(const FoundCycle& found) const {
  v1::Record record;
  v1::FixedPointRecord& out = *record.mutable_fixed_point();
  *out.mutable_cycle() = FromCycle(found.cycle, frame_);
  if (found.first_start >= 0) out.set_first_start(found.first_start);
  return Serialize(record);
}

absl::StatusOr<std::string> CycleSearchPlan::Finish(std::string_view state) const {
  CELT_ASSIGN_OR_RETURN(const CycleSearchState known, DecodeSearch(state));
  const std::vector<int> mirrors = MirrorIndices(*map_, options_, known.cycles);
  v1::Result result;
  v1::FixedPointResult& out = *result.mutable_fixed_point();
  const auto shown =
      std::min<std::int64_t>(kMostResultPoints / options_.period, std::ssize(known.cycles));
  for (std::int64_t i = 0; i < shown; ++i) {
    const FoundCycle& found = known.cycles[i];
    *out.add_cycles() = FromCycle(found.cycle, frame_);
    out.add_hits(found.hits);
    out.add_twins(found.twins);
    out.add_mirrors(mirrors[i] < shown ? mirrors[i] : -1);
  }
  *out.mutable_tally() = FromTally(known.tally);
  std::vector<CycleReport> cycles;
  for (const FoundCycle& found : known.cycles) cycles.push_back(found.cycle);
  CELT_ASSIGN_OR_RETURN(*out.mutable_accuracy(), MeasureAccuracy(spec_, *map_, SampleOf(cycles)));
  return Serialize(result);
}

}  // namespace celt::plans
