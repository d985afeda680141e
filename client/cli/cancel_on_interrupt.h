#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "absl/status/status.h"
#include "client/client.h"

namespace celt::cli {

/// Cancels a job when an interrupt comes, as long as it lives, from a thread of its own: what asks
/// for the stop (the thread that takes the signals) is never kept waiting for a server.
class CancelOnInterrupt {
 public:
  /// When the server does not take the cancellation, or takes it and two seconds later this still
  /// lives, `give_up` is stopped: nothing is to be waited for.
  CancelOnInterrupt(const client::Client& client, std::string id, std::stop_token interrupt,
                    std::stop_source give_up);

  /// Ends the watch; what the server said to the cancellation, nothing if there was no interrupt.
  std::optional<absl::Status> Finish();

 private:
  void Run(const std::stop_token& done);
  void WaitForTheEnd(const std::stop_token& done);
  void Wake();

  const client::Client& client_;
  const std::string id_;
  std::stop_source give_up_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  bool interrupted_ = false;
  std::optional<absl::Status> answer_;
  std::stop_callback<std::function<void()>> on_interrupt_;
  std::jthread thread_;
};

}  // namespace celt::cli
