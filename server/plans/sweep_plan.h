#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/map/system.h"
#include "server/jobs/plan.h"
#include "server/plans/sweep_grid.h"

namespace celt::plans {

/// An analysis at each node of a grid. Every node is a job of its own, run from start to end within
/// a unit; one that fails leaves the reason in its record and stops nothing.
///
/// Nodes that start on their own: a chain is a block of nodes, about a second's worth, and has one
/// unit. Nodes that follow an attractor: a chain is a row of the grid, a unit one node, and the
/// checkpoint the point from which the next node starts: where an orbit of the node ends after its
/// transient and its share of the iterates.
class SweepPlan final : public jobs::Plan {
 public:
  explicit SweepPlan(const v1::JobSpec& resolved);

  std::int64_t chains() const override;
  std::int64_t steps() const override { return follow_ ? grid_.columns() : 1; }
  jobs::Work work() const override;
  absl::StatusOr<jobs::UnitOutput> Run(jobs::UnitId unit, std::string_view checkpoint,
                                       const jobs::StopRequested& stop) const override;
  absl::StatusOr<jobs::Collected> Collect(jobs::UnitId unit, std::string_view state,
                                          std::string_view payload) const override;
  absl::StatusOr<std::string> Finish(std::string_view state) const override;

 private:
  absl::StatusOr<jobs::UnitOutput> RunBlock(std::int64_t block,
                                            const jobs::StopRequested& stop) const;
  absl::StatusOr<jobs::UnitOutput> RunFollowing(std::int64_t node, std::string_view checkpoint,
                                                const jobs::StopRequested& stop) const;

  const SweepGrid grid_;
  const bool follow_;
  const std::int64_t block_;
};

/// For the table of analyses.
absl::Status ResolveSweep(const System& system, v1::JobSpec& spec);
absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeSweepPlan(const v1::JobSpec& resolved);

}  // namespace celt::plans
