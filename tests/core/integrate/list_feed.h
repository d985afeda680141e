#pragma once

#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "core/integrate/crossing.h"

namespace celt {

/// Feeds a list of tasks in order and keeps what comes back.
class ListFeed final : public CrossingFeed {
 public:
  explicit ListFeed(std::vector<CrossingTask> tasks)
      : crossings(tasks.size()), statuses(tasks.size()), tasks_(std::move(tasks)) {}
  bool Next(CrossingTask& task, int& ticket) override {
    if (next_ == tasks_.size()) return false;
    task = tasks_[next_];
    ticket = static_cast<int>(next_++);
    return true;
  }
  void Done(int ticket, const absl::Status& status, const Crossing& crossing) override {
    statuses[ticket] = status;
    crossings[ticket] = crossing;
  }

  std::vector<Crossing> crossings;
  std::vector<absl::Status> statuses;

 private:
  std::vector<CrossingTask> tasks_;
  std::size_t next_ = 0;
};

}  // namespace celt
