#include "client/cli/cancel_on_interrupt.h"

#include <utility>

namespace celt::cli {
namespace {

constexpr absl::Duration kPatience = absl::Seconds(2);

}  // namespace

CancelOnInterrupt::CancelOnInterrupt(const client::Client& client, std::string id,
                                     std::stop_token interrupt, std::stop_source give_up)
    : client_(client),
      id_(std::move(id)),
      give_up_(std::move(give_up)),
      on_interrupt_(std::move(interrupt), [this] { Wake(); }),
      thread_([this](const std::stop_token& done) { Run(done); }) {}

std::optional<absl::Status> CancelOnInterrupt::Finish() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  return answer_;
}

void CancelOnInterrupt::Run(const std::stop_token& done) {
  {
    std::unique_lock lock(mutex_);
    if (!wake_.wait(lock, done, [this] { return interrupted_; })) return;
  }
  answer_ = client_.Cancel(id_, kPatience).status();
  if (answer_->ok()) WaitForTheEnd(done);
  if (!done.stop_requested()) give_up_.request_stop();
}

void CancelOnInterrupt::WaitForTheEnd(const std::stop_token& done) {
  std::unique_lock lock(mutex_);
  wake_.wait_for(lock, done, absl::ToChronoSeconds(kPatience), [] { return false; });
}

void CancelOnInterrupt::Wake() {
  {
    const std::lock_guard lock(mutex_);
    interrupted_ = true;
  }
  wake_.notify_all();
}

}  // namespace celt::cli
