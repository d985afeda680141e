#include "client/reconnect.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace celt::client {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kFirstPause = std::chrono::milliseconds(50);
constexpr auto kLongestPause = std::chrono::milliseconds(1600);

void Pause(Clock::duration length, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any wake;
  std::unique_lock lock(mutex);
  wake.wait_for(lock, stop, length, [] { return false; });
}

/// A server that goes down ends the streams that it knows with UNAVAILABLE; gRPC resets those that
/// arrive in that moment, which looks like a cancellation that nobody here asked for.
bool BrokeOff(const absl::Status& status) {
  return absl::IsUnavailable(status) || absl::IsCancelled(status);
}

absl::Status GiveUp(const absl::Status& status) {
  if (absl::IsUnavailable(status)) return status;
  return absl::UnavailableError("the server reset the stream");
}

}  // namespace

absl::Status Reconnect(absl::Duration patience, const std::stop_token& stop, Attempt attempt) {
  const Clock::duration limit = absl::ToChronoNanoseconds(patience);
  Clock::time_point last_arrival = Clock::now();
  Clock::duration pause = kFirstPause;
  while (true) {
    bool progressed = false;
    absl::Status status = attempt(progressed);
    if (stop.stop_requested()) return absl::CancelledError("stopped");
    if (!BrokeOff(status)) return status;
    if (progressed) {
      last_arrival = Clock::now();
      pause = kFirstPause;
    }
    const Clock::duration left = limit - (Clock::now() - last_arrival);
    if (left <= Clock::duration::zero()) return GiveUp(status);
    Pause(std::min(pause, left), stop);
    pause = std::min<Clock::duration>(2 * pause, kLongestPause);
  }
}

}  // namespace celt::client
