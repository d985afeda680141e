#include "server/jobs/fold.h"

#include <utility>

#include "server/jobs/status_macros.h"

namespace celt::jobs {

Fold::Fold(const Plan& plan, const Progress& progress, double work_done)
    : plan_(plan),
      chains_(plan.chains()),
      steps_(plan.steps()),
      state_(progress.fold_state),
      next_(progress.fold_next),
      work_done_(work_done) {
  for (const PendingPayload& pending : progress.pending) {
    pending_.emplace(pending.unit, pending.payload);
  }
  for (const ChainPosition& chain : progress.chains) {
    if (chain.ended) short_chains_.emplace(chain.chain, chain.next_step);
  }
}

absl::StatusOr<UnitCommit> Fold::Add(const ChainPosition& before, UnitOutput output) {
  const UnitId unit{before.next_step, before.chain};
  UnitCommit commit;
  commit.position = {.chain = before.chain,
                     .next_step = before.next_step + 1,
                     .checkpoint = std::move(output.checkpoint),
                     .ended = output.chain_ended};
  if (output.chain_ended) short_chains_.emplace(before.chain, before.next_step + 1);
  pending_.emplace(unit, std::move(output.payload));
  work_done_ += output.work;
  commit.work_done = work_done_;
  CELT_RETURN_IF_ERROR(FoldReady(unit, commit));
  if (const auto waiting = pending_.find(unit); waiting != pending_.end()) {
    commit.added.push_back({unit, waiting->second});
  }
  commit.fold_next = next_;
  return commit;
}

absl::Status Fold::FoldReady(UnitId added, UnitCommit& commit) {
  for (auto ready = pending_.find(next_); ready != pending_.end(); ready = pending_.find(next_)) {
    CELT_ASSIGN_OR_RETURN(Collected collected, plan_.Collect(next_, state_, ready->second));
    state_ = std::move(collected.state);
    for (std::string& record : collected.records) commit.records.push_back(std::move(record));
    commit.fold_state = state_;
    // The unit's own payload never got into the store.
    if (next_ != added) commit.collected.push_back(next_);
    ++commit.folded;
    pending_.erase(ready);
    next_ = After(next_);
  }
  return absl::OkStatus();
}

bool Fold::Exists(UnitId unit) const {
  const auto found = short_chains_.find(unit.chain);
  return found == short_chains_.end() || unit.step < found->second;
}

UnitId Fold::After(UnitId unit) const {
  do {
    ++unit.chain;
    if (unit.chain >= chains_) unit = UnitId{unit.step + 1, 0};
    // With every chain ended early the plan is over before its last step.
    if (unit.chain == 0 && std::ssize(short_chains_) == chains_) {
      bool any = false;
      for (const auto& [chain, end] : short_chains_) any = any || unit.step < end;
      if (!any) return UnitId{steps_, 0};
    }
  } while (unit.step < steps_ && !Exists(unit));
  return unit;
}

}  // namespace celt::jobs
