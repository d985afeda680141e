#pragma once

#include <functional>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/time/clock.h"
#include "absl/time/time.h"

namespace celt::auth {

/// How files of keys are watched, and who is told of one that can't be used.
struct WatchOptions {
  std::function<absl::Time()> clock = absl::Now;
  absl::Duration look_after = absl::Seconds(1);  ///< between looks at the files
  std::function<void(const absl::Status&)> on_error = [](const absl::Status&) {};
};

/// Tells when one of some files is another than before. Not safe to use from several threads.
class WatchedFiles {
 public:
  /// Takes the files as they are now for known. Empty paths are left out.
  WatchedFiles(std::vector<std::string> paths, const WatchOptions& options);

  /// Whether one has changed since it was asked last; looks no oftener than it is told to.
  bool Changed();

 private:
  std::string Stamp() const;

  const std::vector<std::string> paths_;
  const std::function<absl::Time()> clock_;
  const absl::Duration look_after_;
  std::string stamp_;
  absl::Time looked_;
};

}  // namespace celt::auth
