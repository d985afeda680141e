#include "server/host/keeper.h"

#include <utility>

#include "absl/time/clock.h"

namespace celt::host {

Keeper::Keeper(jobs::JobStore& store, const jobs::Retention& retention, absl::Duration interval,
               std::function<void(const absl::Status&)> on_error)
    : store_(store),
      retention_(retention),
      interval_(interval),
      on_error_(std::move(on_error)),
      thread_([this](const std::stop_token& stop) { Run(stop); }) {}

void Keeper::Run(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    Keep(stop);
    wake_.wait_for(lock, stop, absl::ToChronoNanoseconds(interval_), [] { return false; });
  }
}

void Keeper::Keep(const std::stop_token& stop) {
  for (bool more = true; more && !stop.stop_requested();) {
    const absl::StatusOr<bool> kept = store_.Retain(retention_, absl::Now());
    if (!kept.ok()) on_error_(kept.status());
    more = kept.value_or(false);
  }
}

}  // namespace celt::host
