#include "server/jobs/notifier.h"

#include <utility>
#include <vector>

namespace celt::jobs {

Notifier::Subscription::Subscription(Notifier* notifier, std::string job, std::uint64_t key)
    : notifier_(notifier), job_(std::move(job)), key_(key) {}

Notifier::Subscription& Notifier::Subscription::operator=(Subscription&& other) noexcept {
  End();
  notifier_ = std::exchange(other.notifier_, nullptr);
  job_ = std::move(other.job_);
  key_ = other.key_;
  return *this;
}

void Notifier::Subscription::End() {
  if (notifier_ != nullptr) std::exchange(notifier_, nullptr)->Unsubscribe(job_, key_);
}

Notifier::Subscription Notifier::Subscribe(std::string_view job, Callback callback) {
  const std::lock_guard lock(mutex_);
  const std::uint64_t key = ++last_key_;
  jobs_[std::string(job)].emplace(key, std::make_shared<const Callback>(std::move(callback)));
  return {this, std::string(job), key};
}

void Notifier::Unsubscribe(const std::string& job, std::uint64_t key) {
  // Destroyed after the lock is let go: what a callback holds may have a destructor that comes back
  // here.
  std::shared_ptr<const Callback> last;
  const std::lock_guard lock(mutex_);
  const auto found = jobs_.find(job);
  if (found == jobs_.end()) return;
  if (const auto entry = found->second.find(key); entry != found->second.end()) {
    last = std::move(entry->second);
    found->second.erase(entry);
  }
  if (found->second.empty()) jobs_.erase(found);
}

void Notifier::Notify(std::string_view job) const {
  std::vector<std::shared_ptr<const Callback>> callbacks;
  {
    const std::lock_guard lock(mutex_);
    const auto found = jobs_.find(job);
    if (found == jobs_.end()) return;
    for (const auto& [key, callback] : found->second) callbacks.push_back(callback);
  }
  for (const auto& callback : callbacks) (*callback)();
}

}  // namespace celt::jobs
