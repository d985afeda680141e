#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "core/analysis/lyapunov.h"
#include "core/map/map.h"
#include "server/jobs/plan.h"
#include "server/plans/lyapunov_schedule.h"
#include "server/plans/lyapunov_state.h"

namespace celt::plans {

/// The Lyapunov spectrum as work units. A chain is a group of orbits that are advanced together, so
/// that an engine with several lanes has something for each; a step is a stretch of their iterates.
/// The checkpoint is where the orbits stand, the payload each orbit's sums and what it gives
/// to the sample, the fold's state the sums by batch and the sample. Orbits are added up in their
/// own order whatever the groups, so that these do not show in the answer.
class LyapunovPlan final : public jobs::Plan {
 public:
  /// `group_size` 0: 8 orbits, as many as the fast engine has lanes on the widest machine.
  static absl::StatusOr<std::unique_ptr<LyapunovPlan>> Make(const v1::JobSpec& resolved,
                                                            std::int64_t group_size = 0);

  std::int64_t chains() const override;
  std::int64_t steps() const override { return schedule_.steps(); }
  jobs::Work work() const override;
  absl::StatusOr<jobs::UnitOutput> Run(jobs::UnitId unit, std::string_view checkpoint,
                                       const jobs::StopRequested& stop) const override;
  absl::StatusOr<jobs::Collected> Collect(jobs::UnitId unit, std::string_view state,
                                          std::string_view payload) const override;
  absl::StatusOr<std::string> Finish(std::string_view state) const override;

 private:
  LyapunovPlan(const v1::JobSpec& resolved, std::unique_ptr<Map> map, std::int64_t group_size);

  std::int64_t FirstOrbit(std::int64_t chain) const { return chain * group_size_; }
  std::int64_t EndOrbit(std::int64_t chain) const;
  absl::StatusOr<std::vector<FramedOrbit>> Starts(std::int64_t chain) const;
  absl::StatusOr<std::vector<LyapunovSums>> Advance(jobs::UnitId unit,
                                                    std::vector<FramedOrbit>& orbits,
                                                    const jobs::StopRequested& stop) const;
  LyapunovTally Tally(jobs::UnitId unit, std::vector<LyapunovSums> sums,
                      const std::vector<FramedOrbit>& orbits) const;

  const v1::JobSpec spec_;
  const std::unique_ptr<Map> map_;
  const std::int64_t orbits_;
  const std::int64_t group_size_;
  const LyapunovSchedule schedule_;
};

/// For the table of analyses.
absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeLyapunovPlan(const v1::JobSpec& resolved);

}  // namespace celt::plans
