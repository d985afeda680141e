#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "server/auth/watched_files.h"

namespace celt::host {

struct Keys;

/// The files of a server's TLS, contents in PEM.
struct Certificates {
  std::string chain;  ///< of the server
  std::string key;
  std::string client_authorities;  ///< empty: none
};

/// Reads them, again when they have changed. What can't be used (no PEM, a key of another
/// certificate, a file that is not there) is told of, and what was before holds. Safe to use from
/// many threads.
class CertificateFiles {
 public:
  /// INVALID_ARGUMENT names the setting and the file that can't be used.
  static absl::StatusOr<std::unique_ptr<CertificateFiles>> Open(const Keys& keys,
                                                                const auth::WatchOptions& options);

  /// What was read and not yet taken: at first, and when the files have changed since.
  std::optional<Certificates> Take();

 private:
  CertificateFiles(const Keys& keys, const auth::WatchOptions& options);
  absl::StatusOr<Certificates> Read() const;

  const std::string chain_path_;
  const std::string key_path_;
  const std::string authorities_path_;
  const std::function<void(const absl::Status&)> on_error_;
  std::mutex mutex_;
  auth::WatchedFiles files_;
  std::optional<Certificates> read_;
};

}  // namespace celt::host
