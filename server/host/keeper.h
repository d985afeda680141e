#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "server/jobs/store.h"

namespace celt::host {

/// Drops what need not be kept, now and then, in a thread of its own, as long as it lives.
class Keeper {
 public:
  /// `store` must outlive this. `on_error` is told what went wrong; it is tried again later.
  Keeper(jobs::JobStore& store, const jobs::Retention& retention, absl::Duration interval,
         std::function<void(const absl::Status&)> on_error);

 private:
  void Run(const std::stop_token& stop);
  void Keep(const std::stop_token& stop);

  jobs::JobStore& store_;
  const jobs::Retention retention_;
  const absl::Duration interval_;
  const std::function<void(const absl::Status&)> on_error_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;
};

}  // namespace celt::host
