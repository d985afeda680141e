#include "server/auth/watched_files.h"

#include <sys/stat.h>

#include <utility>

#include "absl/strings/str_cat.h"

namespace celt::auth {

WatchedFiles::WatchedFiles(std::vector<std::string> paths, const WatchOptions& options)
    : paths_(std::move(paths)),
      clock_(options.clock),
      look_after_(options.look_after),
      stamp_(Stamp()),
      looked_(clock_()) {}

bool WatchedFiles::Changed() {
  const absl::Time now = clock_();
  if (now - looked_ < look_after_) return false;
  looked_ = now;
  return std::exchange(stamp_, Stamp()) != stamp_;
}

/// Changes when a file does, also when it is replaced by another within a clock's tick.
std::string WatchedFiles::Stamp() const {
  std::string stamp;
  for (const std::string& path : paths_) {
    struct stat status {};
    if (path.empty() || stat(path.c_str(), &status) != 0) {
      absl::StrAppend(&stamp, "none;");
      continue;
    }
    absl::StrAppend(&stamp, status.st_ino, " ", status.st_size, " ", status.st_mtim.tv_sec, ".",
                    status.st_mtim.tv_nsec, ";");
  }
  return stamp;
}

}  // namespace celt::auth
