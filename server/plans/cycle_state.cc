#include "server/plans/cycle_state.h"

#include <array>
#include <cstddef>
#include <utility>

#include "server/jobs/status_macros.h"
#include "server/plans/serialize.h"

namespace celt::plans {
namespace {

absl::Status Damaged() { return absl::DataLossError("the stored state of a cycle is damaged"); }

constexpr std::array kCounts = {
    &CycleSearchTally::starts,         &CycleSearchTally::found,       &CycleSearchTally::shorter,
    &CycleSearchTally::no_convergence, &CycleSearchTally::left_domain, &CycleSearchTally::singular,
    &CycleSearchTally::outside,
};

}  // namespace

CycleState ToState(const CycleReport& cycle) {
  CycleState state;
  state.set_termination(static_cast<int>(cycle.termination));
  state.set_message(cycle.message);
  state.set_iterations(cycle.iterations);
  if (!cycle.points.empty()) state.set_dimension(static_cast<int>(cycle.points.front().size()));
  for (const Point& point : cycle.points) state.mutable_points()->Add(point.begin(), point.end());
  state.set_residual(cycle.residual);
  state.set_correction(cycle.correction);
  state.set_minimal_period(cycle.minimal_period);
  state.set_return_time(cycle.return_time);
  for (const Multiplier& multiplier : cycle.multipliers) {
    state.add_multipliers(multiplier.real());
    state.add_multipliers(multiplier.imag());
  }
  return state;
}

absl::StatusOr<CycleReport> FromState(const CycleState& state) {
  const int n = state.dimension();
  const bool whole = n > 0 && n <= kMaxDimension && state.points_size() % n == 0;
  if (!whole && state.points_size() > 0) return Damaged();
  CycleReport cycle;
  cycle.termination = static_cast<CycleTermination>(state.termination());
  cycle.message = state.message();
  cycle.iterations = state.iterations();
  for (int i = 0; i < state.points_size(); i += n) {
    cycle.points.emplace_back(Eigen::Map<const Eigen::VectorXd>(&state.points().Get(i), n));
  }
  cycle.residual = state.residual();
  cycle.correction = state.correction();
  cycle.minimal_period = state.minimal_period();
  cycle.return_time = state.return_time();
  for (int i = 0; i + 1 < state.multipliers_size(); i += 2) {
    cycle.multipliers.emplace_back(state.multipliers(i), state.multipliers(i + 1));
  }
  return cycle;
}

std::string EncodeSearch(const CycleSearchState& search) {
  CycleSearchProgress progress;
  for (const FoundCycle& found : search.cycles) {
    FoundCycleState& out = *progress.add_cycles();
    *out.mutable_cycle() = ToState(found.cycle);
    out.set_first_start(found.first_start);
    out.set_hits(found.hits);
    out.set_twins(found.twins);
  }
  for (const auto count : kCounts) progress.add_tally(search.tally.*count);
  return Serialize(progress);
}

absl::StatusOr<CycleSearchState> DecodeSearch(std::string_view bytes) {
  CycleSearchState search;
  if (bytes.empty()) return search;
  CELT_ASSIGN_OR_RETURN(const CycleSearchProgress progress, Parse<CycleSearchProgress>(bytes));
  if (progress.tally_size() != std::ssize(kCounts)) return Damaged();
  for (const FoundCycleState& in : progress.cycles()) {
    FoundCycle& found = search.cycles.emplace_back();
    CELT_ASSIGN_OR_RETURN(found.cycle, FromState(in.cycle()));
    found.first_start = in.first_start();
    found.hits = in.hits();
    found.twins = in.twins();
  }
  for (std::size_t i = 0; i < kCounts.size(); ++i) {
    search.tally.*kCounts[i] = progress.tally(static_cast<int>(i));
  }
  return search;
}

}  // namespace celt::plans
