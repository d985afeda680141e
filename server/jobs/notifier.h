#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace celt::jobs {

/// Tells whoever asked that something about a job has changed: look again. Safe to use from many
/// threads. Callbacks run on the thread that made the change, with no lock held; they must be quick
/// and must not throw. One may still be running, or about to, when its subscription has just ended:
/// let it hold what it touches alive.
class Notifier {
 public:
  using Callback = std::function<void()>;

  /// Ends with its life. The notifier must outlive it.
  class Subscription {
   public:
    Subscription() = default;
    Subscription(Notifier* notifier, std::string job, std::uint64_t key);
    Subscription(Subscription&& other) noexcept { *this = std::move(other); }
    Subscription& operator=(Subscription&& other) noexcept;
    ~Subscription() { End(); }
    void End();

   private:
    Notifier* notifier_ = nullptr;
    std::string job_;
    std::uint64_t key_ = 0;
  };

  [[nodiscard]] Subscription Subscribe(std::string_view job, Callback callback);
  void Notify(std::string_view job) const;

 private:
  void Unsubscribe(const std::string& job, std::uint64_t key);

  using Callbacks = std::map<std::uint64_t, std::shared_ptr<const Callback>>;
  mutable std::mutex mutex_;
  std::map<std::string, Callbacks, std::less<>> jobs_;
  std::uint64_t last_key_ = 0;
};

}  // namespace celt::jobs
