#include "server/jobs/data_dir.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

constexpr mode_t kOwnerOnly = S_IRUSR | S_IWUSR;

absl::Status Fail(const std::string& path, const std::string& why) {
  return absl::FailedPreconditionError(absl::StrCat("data directory ", path, ": ", why));
}

absl::Status MakeDirectory(const std::string& path) {
  std::error_code error;
  const bool made = std::filesystem::create_directories(path, error);
  if (error) return Fail(path, error.message());
  if (made) std::filesystem::permissions(path, std::filesystem::perms::owner_all, error);
  return error ? Fail(path, error.message()) : absl::OkStatus();
}

}  // namespace

absl::StatusOr<DataDir> DataDir::Lock(const std::string& path) {
  CELT_RETURN_IF_ERROR(MakeDirectory(path));
  const int lock = open((path + "/lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kOwnerOnly);
  if (lock < 0) return Fail(path, std::generic_category().message(errno));
  DataDir directory(path, lock);
  if (flock(lock, LOCK_EX | LOCK_NB) == 0) return directory;
  if (errno != EWOULDBLOCK) return Fail(path, std::generic_category().message(errno));
  return absl::UnavailableError(
      absl::StrCat("data directory ", path, ": in use by another celt or celtd"));
}

DataDir::DataDir(DataDir&& other) noexcept
    : path_(std::move(other.path_)), lock_(std::exchange(other.lock_, -1)) {}

DataDir& DataDir::operator=(DataDir&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(lock_, other.lock_);
  return *this;
}

DataDir::~DataDir() {
  if (lock_ >= 0) close(lock_);
}

}  // namespace celt::jobs
