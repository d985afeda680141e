#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <set>

#include "absl/status/status.h"

namespace celt::api {

/// A stream that can be ended from outside.
class Endable {
 public:
  virtual ~Endable() = default;
  virtual void End(const absl::Status& why) = 0;
};

/// The streams that are open, so that a server that goes down can end them: it never would while
/// one is open. Safe to use from many threads.
class OpenStreams {
 public:
  /// Ends the stream at once when EndAll was called before.
  void Add(const std::shared_ptr<Endable>& stream);
  void Remove(const std::shared_ptr<Endable>& stream);
  std::int64_t size();
  /// Ends all, now and in future.
  void EndAll(const absl::Status& why);

 private:
  std::mutex mutex_;
  std::set<std::shared_ptr<Endable>> streams_;
  absl::Status ended_;
};

}  // namespace celt::api
