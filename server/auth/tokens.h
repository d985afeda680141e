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
#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "server/auth/identity.h"

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
  struct Options {
    std::function<absl::Time()> clock = absl::Now;
    absl::Duration look_after = absl::Seconds(1);  ///< between looks at the file
    std::function<void(const absl::Status&)> on_error = [](const absl::Status&) {};
  };

  /// INVALID_ARGUMENT "path:line: …"; NOT_FOUND: it can't be read.
  static absl::StatusOr<std::unique_ptr<TokenFile>> Open(const std::string& path, Options options);

  std::optional<Identity> Find(std::string_view token);

 private:
  using Identities = std::map<std::string, Identity, std::less<>>;  // by hash

  TokenFile(std::string path, Options options)
      : path_(std::move(path)), options_(std::move(options)) {}
  void LookAgain();
  absl::StatusOr<Identities> Read() const;
  std::string Stamp() const;

  const std::string path_;
  const Options options_;
  std::mutex mutex_;
  Identities identities_;
  std::string stamp_;  // of the file that was read last
  absl::Time looked_;
};

}  // namespace celt::auth
