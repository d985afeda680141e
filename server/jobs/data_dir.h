#pragma once

#include <string>

#include "absl/status/statusor.h"

namespace celt::jobs {

/// A data directory held by this process alone, until the end of this object's life or of the
/// process, however it ends. Movable.
class DataDir {
 public:
  /// Makes the directory (for its owner only) if there is none. UNAVAILABLE: another
  /// process has it. FAILED_PRECONDITION: it can't be made or written.
  static absl::StatusOr<DataDir> Lock(const std::string& path);
  DataDir(DataDir&& other) noexcept;
  DataDir& operator=(DataDir&& other) noexcept;
  ~DataDir();

  /// Where the job store lives.
  std::string StorePath() const { return path_ + "/jobs.sqlite"; }

 private:
  DataDir(std::string path, int lock) : path_(std::move(path)), lock_(lock) {}

  std::string path_;
  int lock_ = -1;  // descriptor of the locked file
};

}  // namespace celt::jobs
