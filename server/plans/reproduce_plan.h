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

namespace celt::plans {

/// The paper's table as work units: a chain is an item of the table, and has one unit. An item that
/// fails leaves a row that says why, and stops nothing.
class ReproducePlan final : public jobs::Plan {
 public:
  explicit ReproducePlan(const v1::JobSpec& resolved) : spec_(resolved) {}

  std::int64_t chains() const override;
  std::int64_t steps() const override { return 1; }
  jobs::Work work() const override;
  absl::StatusOr<jobs::UnitOutput> Run(jobs::UnitId unit, std::string_view checkpoint,
                                       const jobs::StopRequested& stop) const override;
  absl::StatusOr<jobs::Collected> Collect(jobs::UnitId unit, std::string_view state,
                                          std::string_view payload) const override;
  absl::StatusOr<std::string> Finish(std::string_view state) const override;

 private:
  const v1::JobSpec spec_;
};

/// For the table of analyses. Only for the Celtic stone with the paper's parameters.
absl::Status ResolveReproduce(const System& system, v1::JobSpec& spec);
absl::StatusOr<std::unique_ptr<jobs::Plan>> MakeReproducePlan(const v1::JobSpec& resolved);

}  // namespace celt::plans
