#include "server/plans/sweep_plan.h"

#include <algorithm>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"
#include "server/plans/load.h"
#include "server/plans/serialize.h"
#include "server/plans/state.pb.h"
#include "server/plans/sweep_node.h"

namespace celt::plans {
namespace {

/// Cost of a unit in iterates, about a second's worth; a matter of the specification alone.
constexpr double kUnitCost = 100'000;
constexpr double kMostNodesInUnit = 1000;

std::int64_t BlockSize(const SweepGrid& grid) {
  const v1::JobSpec first = grid.NodeSpec(0);
  // Either end may lie where the system has no motion.
  const double work = std::max({NodeWork(first), NodeWork(grid.NodeSpec(grid.nodes() - 1)), 1.0});
  const double cost = CostOfWork(first) * work;
  return static_cast<std::int64_t>(std::clamp(kUnitCost / cost, 1.0, kMostNodesInUnit));
}

v1::SweepRecord RecordAt(const SweepGrid& grid, std::int64_t node) {
  v1::SweepRecord record;
  record.set_node(node);
  const std::vector<double> values = grid.Values(node);
  record.mutable_values()->Add(values.begin(), values.end());
  return record;
}

void Add(const v1::SweepRecord& sweep, ChainPayload& payload) {
  v1::Record record;
  *record.mutable_sweep() = sweep;
  payload.add_records(Serialize(record));
}

std::string EncodePoint(const Point& point) {
  Numbers numbers;
  numbers.mutable_numbers()->Add(point.begin(), point.end());
  return Serialize(numbers);
}

absl::StatusOr<Point> DecodePoint(std::string_view bytes) {
  CELT_ASSIGN_OR_RETURN(const Numbers numbers, Parse<Numbers>(bytes));
  if (numbers.numbers_size() > kMaxDimension) {
    return absl::DataLossError("the stored state of the job is damaged");
  }
  Point point(numbers.numbers_size());
  std::copy(numbers.numbers().begin(), numbers.numbers().end(), point.begin());
  return point;
}

/// What is left of an attractor that was carried to a node: where to start, or why there is
/// nothing.
absl::Status Receive(std::string_view checkpoint, v1::JobSpec& node) {
  if (checkpoint.empty()) return absl::OkStatus();
  CELT_ASSIGN_OR_RETURN(const ChainCheckpoint before, Parse<ChainCheckpoint>(checkpoint));
  if (before.error_code() != 0) {
    return absl::Status(static_cast<absl::StatusCode>(before.error_code()), before.error_message());
  }
  CELT_ASSIGN_OR_RETURN(const Point start, DecodePoint(before.state()));
  SetStart(start, node);
  return absl::OkStatus();
}

/// Where the attractor goes on from a node.
absl::StatusOr<Point> EndOf(v1::JobSpec node, const jobs::StopRequested& stop) {
  CELT_RETURN_IF_ERROR(ResolveNode(node));
  return CarryOn(node, stop);
}

std::string Lost(const absl::Status& why, const v1::SweepRecord& at) {
  ChainCheckpoint checkpoint;
  checkpoint.set_error_code(why.raw_code());
  checkpoint.set_error_message(absl::StrCat("the attractor was lost at node ", at.node(),
                                            ", value ", at.values(0), ": ", why.message()));
  return Serialize(checkpoint);
}

}  // namespace

SweepPlan::SweepPlan(const v1::JobSpec& resolved)
    : grid_(resolved),
      follow_(resolved.sweep().follow()),
      block_(follow_ ? grid_.columns() : BlockSize(grid_)) {}

std::int64_t SweepPlan::chains() const { return (grid_.nodes() + block_ - 1) / block_; }

jobs::Work SweepPlan::work() const {
  return {.total = static_cast<double>(grid_.nodes()), .unit = "nodes"};
}

absl::StatusOr<jobs::UnitOutput> SweepPlan::Run(jobs::UnitId unit, std::string_view checkpoint,
                                                const jobs::StopRequested& stop) const {
  if (!follow_) return RunBlock(unit.chain, stop);
  return RunFollowing(unit.chain * grid_.columns() + unit.step, checkpoint, stop);
}

absl::StatusOr<jobs::UnitOutput> SweepPlan::RunBlock(std::int64_t block,
                                                     const jobs::StopRequested& stop) const {
  const std::int64_t first = block * block_;
  const std::int64_t end = std::min(first + block_, grid_.nodes());
  ChainPayload payload;
  for (std::int64_t node = first; node < end; ++node) {
    v1::SweepRecord record = RecordAt(grid_, node);
    CELT_RETURN_IF_ERROR(RunNode(grid_.NodeSpec(node), stop, record));
    Add(record, payload);
  }
  jobs::UnitOutput output;
  output.payload = Serialize(payload);
  output.work = static_cast<double>(end - first);
  return output;
}

absl::StatusOr<jobs::UnitOutput> SweepPlan::RunFollowing(std::int64_t node,
                                                         std::string_view checkpoint,
                                                         const jobs::StopRequested& stop) const {
  v1::JobSpec spec = grid_.NodeSpec(node);
  v1::SweepRecord record = RecordAt(grid_, node);
  jobs::UnitOutput output;
  output.work = 1;
  if (const absl::Status lost = Receive(checkpoint, spec); !lost.ok()) {
    if (absl::IsDataLoss(lost)) return lost;
    record.mutable_error()->set_code(lost.raw_code());
    record.mutable_error()->set_message(std::string(lost.message()));
    output.checkpoint = std::string(checkpoint);
  } else {
    CELT_RETURN_IF_ERROR(RunNode(spec, stop, record));
    const absl::StatusOr<Point> end = EndOf(spec, stop);
    if (absl::IsCancelled(end.status())) return end.status();
    ChainCheckpoint after;
    if (end.ok()) after.set_state(EncodePoint(*end));
    output.checkpoint = end.ok() ? Serialize(after) : Lost(end.status(), record);
  }
  ChainPayload payload;
  Add(record, payload);
  output.payload = Serialize(payload);
  return output;
}

/// The state counts nodes: failed ones, then each regime.
absl::StatusOr<jobs::Collected> SweepPlan::Collect(jobs::UnitId, std::string_view state,
                                                   std::string_view payload) const {
  CELT_ASSIGN_OR_RETURN(const ChainPayload unit, Parse<ChainPayload>(payload));
  CELT_ASSIGN_OR_RETURN(Numbers counts, Parse<Numbers>(state));
  jobs::Collected collected;
  collected.records.assign(unit.records().begin(), unit.records().end());
  while (counts.counts_size() < v1::Regime_ARRAYSIZE + 1) counts.add_counts(0);
  for (const std::string& bytes : collected.records) {
    CELT_ASSIGN_OR_RETURN(const v1::Record record, Parse<v1::Record>(bytes));
    const v1::SweepRecord& node = record.sweep();
    int which = -1;
    if (node.has_error()) which = 0;
    if (node.has_lyapunov()) which = 1 + static_cast<int>(node.lyapunov().regime());
    if (which >= 0) counts.set_counts(which, counts.counts(which) + 1);
  }
  collected.state = Serialize(counts);
  return collected;
}

absl::StatusOr<std::string> SweepPlan::Finish(std::string_view state) const {
  CELT_ASSIGN_OR_RETURN(const Numbers counts, Parse<Numbers>(state));
  v1::Result result;
  v1::SweepResult& sweep = *result.mutable_sweep();
  sweep.set_nodes(grid_.nodes());
  sweep.set_failed(counts.counts_size() > 0 ? counts.counts(0) : 0);
  for (int i = 1; i < counts.counts_size(); ++i) {
    if (counts.counts(i) == 0) continue;
    v1::RegimeCount& count = *sweep.add_regimes();
    count.set_regime(static_cast<v1::Regime>(i - 1));
    count.set_nodes(counts.counts(i));
  }
  return Serialize(result);
}

absl::Status ResolveSweep(const System& system, v1::JobSpec& spec) {
  v1::SweepSpec& sweep = *spec.mutable_sweep();
  CELT_RETURN_IF_ERROR(SweepGrid::Check(system, sweep));
  if (sweep.analysis_case() == v1::SweepSpec::ANALYSIS_NOT_SET) {
    return absl::InvalidArgumentError("sweep.analysis: missing; set lyapunov, section, ...");
  }
  const SweepGrid grid(spec);
  // Numbers are the same at every node; a level may be empty at one end, but not everywhere.
  v1::JobSpec node = grid.NodeSpec(0);
  absl::Status status = ResolveNode(node);
  for (const std::int64_t other : {grid.nodes() - 1, grid.nodes() / 2}) {
    if (status.ok()) break;
    node = grid.NodeSpec(other);
    if (const absl::Status there = ResolveNode(node); there.ok()) status = there;
  }
  CELT_RETURN_IF_ERROR(status);
  if (sweep.follow() && !FollowsOrbit(node)) {
    return absl::InvalidArgumentError(
        "follow: only for analyses of an orbit: lyapunov, section, hyperbolicity");
  }
  PutAnalysis(node, sweep);
  return absl::OkStatus();
}

absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeSweepPlan(const v1::JobSpec& resolved) {
  return std::make_unique<SweepPlan>(resolved);
}

}  // namespace celt::plans
