#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "absl/status/statusor.h"
#include "server/jobs/plan.h"
#include "server/jobs/store.h"

namespace celt::jobs {

/// Folds the payloads of a plan's units in the plan's order, in whatever order the units finish:
/// the heart of the promise that the same specification gives the same bytes. Not safe to use from
/// several threads.
class Fold {
 public:
  /// Goes on where `progress` stands. `plan` must outlive this.
  Fold(const Plan& plan, const Progress& progress, double work_done);

  /// Takes in what the unit at `before` left and folds what can be folded by now. What is returned
  /// must be committed before the next Add. After an error, which is Plan::Collect's, nothing may
  /// be added any more.
  absl::StatusOr<UnitCommit> Add(const ChainPosition& before, UnitOutput output);

  const std::string& state() const { return state_; }

 private:
  absl::Status FoldReady(UnitId added, UnitCommit& commit);
  UnitId After(UnitId unit) const;
  bool Exists(UnitId unit) const;

  const Plan& plan_;
  const std::int64_t chains_;
  const std::int64_t steps_;
  std::map<UnitId, std::string> pending_;
  std::map<std::int64_t, std::int64_t>
      short_chains_;  // that ended early, with the first step that they lack
  std::string state_;
  UnitId next_;
  double work_done_;
};

}  // namespace celt::jobs
