#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/auth/identity.h"
#include "server/auth/watched_files.h"

namespace celt::auth {

/// A token of 256 random bits, in hexadecimal: too many to guess, so that a fast hash of it can't
/// be turned back.
std::string NewToken();
/// SHA-256 in hexadecimal.
std::string HashOf(std::string_view token);
/// The line of a file of tokens that lets `token` in.
std::string TokenLine(const Identity& identity, std::string_view token);

/// The tokens of a file, which has only their hashes: a line "OWNER ROLE HASH" for each, where the
/// role is "user" or "admin"; empty lines and those that begin with # are left out. A file that has
/// changed is read again; one that can't be read then is told of, and what it said before holds.
/// Safe to use from many threads.
class TokenFile {
 public:
  /// INVALID_ARGUMENT "path:line: …"; NOT_FOUND: it can't be read.
  static absl::StatusOr<std::unique_ptr<TokenFile>> Open(const std::string& path,
                                                         WatchOptions options);

  std::optional<Identity> Find(std::string_view token);

 private:
  using Identities = std::map<std::string, Identity, std::less<>>;  // by hash

  TokenFile(std::string path, WatchOptions options)
      : path_(std::move(path)), on_error_(std::move(options.on_error)), file_({path_}, options) {}
  void LookAgain();
  absl::StatusOr<Identities> Read() const;

  const std::string path_;
  const std::function<void(const absl::Status&)> on_error_;
  std::mutex mutex_;
  WatchedFiles file_;
  Identities identities_;
};

}  // namespace celt::auth
