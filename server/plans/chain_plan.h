#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "celt/v1/job.pb.h"
#include "server/jobs/plan.h"

namespace celt::plans {

/// What a unit of a ChainPlan does.
struct Stretch {
  std::string state;                ///< from where the next unit goes on
  std::vector<v1::Record> records;  ///< to be streamed, in this order
  /// For Fold; small, or the store grows with it.
  std::string summary;
  double work = 0;
  bool ended = false;  ///< nothing is left to do
  /// What went wrong after these records; the job keeps them, and fails with this.
  absl::Status error;
};

/// A plan that is one chain: a computation that goes on from where it was, and gives records as it
/// goes. What is left to the analysis is to go on, and to make the result.
class ChainPlan : public jobs::Plan {
 public:
  std::int64_t chains() const final { return 1; }
  /// One more than MostSteps(): a unit that only reports a failure.
  std::int64_t steps() const final { return MostSteps() + 1; }

  absl::StatusOr<jobs::UnitOutput> Run(jobs::UnitId unit, std::string_view checkpoint,
                                       const jobs::StopRequested& stop) const final;
  absl::StatusOr<jobs::Collected> Collect(jobs::UnitId unit, std::string_view state,
                                          std::string_view payload) const final;
  absl::StatusOr<std::string> Finish(std::string_view state) const final;

 private:
  virtual std::int64_t MostSteps() const = 0;
  /// Goes on from `state`, which is empty at first, for about a second or less: a matter of the
  /// specification alone, never of a measured time. CANCELLED only after `stop` said so.
  virtual absl::StatusOr<Stretch> Advance(std::string_view state,
                                          const jobs::StopRequested& stop) const = 0;
  /// Folds a stretch's summary into what is known for the result; empty at first. Default: the
  /// latest summary is all there is to know.
  virtual absl::StatusOr<std::string> Fold(std::string_view known, std::string_view summary) const;
  virtual absl::StatusOr<v1::Result> MakeResult(std::string_view known) const = 0;
};

}  // namespace celt::plans
