#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/analysis/cycle_search.h"
#include "core/map/map.h"
#include "server/jobs/plan.h"
#include "server/plans/convert.h"

namespace celt::plans {

/// A search for cycles as work units. A unit is a block of starts and knows nothing of the others;
/// blocks go round the chains, so that the plan's order is that of the starts. The payload is what
/// the block found, the fold's state what was found so far. Mirror images come after the last
/// block.
class CycleSearchPlan final : public jobs::Plan {
 public:
  static absl::StatusOr<std::unique_ptr<jobs::Plan>> Make(const v1::JobSpec& resolved);

  std::int64_t chains() const override;
  std::int64_t steps() const override;
  jobs::Work work() const override;
  absl::StatusOr<jobs::UnitOutput> Run(jobs::UnitId unit, std::string_view checkpoint,
                                       const jobs::StopRequested& stop) const override;
  absl::StatusOr<jobs::Collected> Collect(jobs::UnitId unit, std::string_view state,
                                          std::string_view payload) const override;
  absl::StatusOr<std::string> Finish(std::string_view state) const override;

 private:
  CycleSearchPlan(const v1::JobSpec& resolved, std::unique_ptr<Map> map,
                  CycleSearchOptions options);

  std::int64_t blocks() const { return (starts_ + block_ - 1) / block_; }
  std::int64_t BlockOf(jobs::UnitId unit) const { return unit.step * chains() + unit.chain; }
  std::string Record(const FoundCycle& found) const;

  const v1::JobSpec spec_;
  const PointFrame frame_;
  const std::unique_ptr<Map> map_;
  const CycleSearchOptions options_;
  const std::int64_t starts_;
  const std::int64_t block_;  // starts of a unit
};

}  // namespace celt::plans
