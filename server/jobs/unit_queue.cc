#include "server/jobs/unit_queue.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace celt::jobs {

UnitQueue::UnitQueue(const Plan& plan, const Progress& progress, std::int64_t run_ahead)
    : chains_(plan.chains()),
      steps_(plan.steps()),
      run_ahead_(run_ahead),
      ahead_(std::ssize(progress.pending)),
      fold_next_(progress.fold_next) {
  for (const ChainPosition& position : progress.chains) {
    begun_at_restart_.insert(position.chain);
    Place(position);
  }
  SkipBegunChains();
}

void UnitQueue::SkipBegunChains() {
  while (begun_at_restart_.erase(first_fresh_) > 0) ++first_fresh_;
}

void UnitQueue::Place(ChainPosition position) {
  if (position.ended || position.next_step >= steps_) {
    begun_.erase(position.chain);
    return;
  }
  ready_.insert(UnitId{position.next_step, position.chain});
  begun_.insert_or_assign(position.chain, std::move(position));
}

std::optional<UnitId> UnitQueue::Lowest() const {
  UnitId lowest{0, first_fresh_};
  if (first_fresh_ >= chains_ || steps_ <= 0) {
    if (ready_.empty()) return std::nullopt;
    lowest = *ready_.begin();
  } else if (!ready_.empty()) {
    lowest = std::min(lowest, *ready_.begin());
  }
  if (failure_ && lowest > failure_->unit) return std::nullopt;
  // The next unit to fold is always allowed, else nothing would ever move again.
  if (ahead_ >= run_ahead_ && lowest != fold_next_) return std::nullopt;
  return lowest;
}

ChainPosition UnitQueue::Take() {
  const std::optional<UnitId> unit = Lowest();
  assert(unit);
  ++ahead_;
  if (ready_.erase(*unit) > 0) return begun_.at(unit->chain);
  ++first_fresh_;
  SkipBegunChains();
  return ChainPosition{.chain = unit->chain, .next_step = 0, .checkpoint = {}, .ended = false};
}

void UnitQueue::Done(ChainPosition after, UnitId fold_next, std::int64_t folded) {
  Place(std::move(after));
  ahead_ -= folded;
  // Commits of one job are in order, but word of them may come here out of order.
  fold_next_ = std::max(fold_next_, fold_next);
}

void UnitQueue::Failed(UnitId unit, const absl::Status& error) {
  if (!failure_ || unit < failure_->unit) failure_ = Failure{unit, error};
}

std::optional<absl::Status> UnitQueue::failure() const {
  if (!failure_ || fold_next_ != failure_->unit) return std::nullopt;
  return failure_->error;
}

}  // namespace celt::jobs
