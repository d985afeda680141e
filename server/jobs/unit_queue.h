#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>

#include "absl/status/status.h"
#include "server/jobs/plan.h"
#include "server/jobs/store.h"

namespace celt::jobs {

/// The units of one plan that are ready to run, the lowest in the plan's order first. How far units
/// may run ahead of the fold is bounded, so that what waits to be folded is bounded too. Not safe
/// to use from several threads.
class UnitQueue {
 public:
  /// Goes on where `progress` stands; `run_ahead` units at most are run but not folded, the next
  /// one to fold aside.
  UnitQueue(const Plan& plan, const Progress& progress, std::int64_t run_ahead);

  bool HasReady() const { return Lowest().has_value(); }
  /// Takes the lowest ready unit: its chain's position before it. Precondition: HasReady().
  ChainPosition Take();

  /// The unit that was taken is done; its chain stands at `after` and the fold at `fold_next`, with
  /// `folded` units folded just now.
  void Done(ChainPosition after, UnitId fold_next, std::int64_t folded);
  /// The unit failed. Nothing that comes after it in the plan's order is begun any more; what comes
  /// before is, so that the records that a failed job leaves, and its error, are always the same.
  void Failed(UnitId unit, const absl::Status& error);

  /// The failure, once everything before it is folded.
  std::optional<absl::Status> failure() const;
  /// Whether everything was folded.
  bool Complete() const { return chains_ == 0 || fold_next_.step >= steps_; }

 private:
  struct Failure {
    UnitId unit;
    absl::Status error;
  };

  std::optional<UnitId> Lowest() const;
  void SkipBegunChains();
  void Place(ChainPosition position);

  const std::int64_t chains_;
  const std::int64_t steps_;
  const std::int64_t run_ahead_;
  std::map<std::int64_t, ChainPosition>
      begun_;  // but not ended; a chain that is running has no unit in ready_
  std::set<std::int64_t> begun_at_restart_;  // those after first_fresh_
  std::set<UnitId> ready_;                   // next units of begun chains
  std::int64_t first_fresh_ = 0;  // no chain from here on was begun, but for begun_at_restart_
  std::int64_t ahead_ = 0;        // units taken but not folded
  UnitId fold_next_;
  std::optional<Failure> failure_;
};

}  // namespace celt::jobs
