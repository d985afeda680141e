#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "server/auth/identity.h"
#include "server/auth/tokens.h"

namespace celt::auth {

/// What a call shows of who makes it.
struct Credentials {
  std::string_view authorization;  ///< the header, such as "Bearer 0123…"; empty for none
  std::string_view common_name;    ///< of the client's certificate, verified; empty for none
};

/// Tells who calls. Safe to use from many threads.
class Gate {
 public:
  /// Lets everybody in as one nameless owner who sees all: for a loopback address.
  Gate() = default;
  /// Lets in who shows a token of the file, if there is one, or a client certificate, if those are
  /// asked for: then the owner is its common name, a user.
  Gate(std::unique_ptr<TokenFile> tokens, bool certificates)
      : tokens_(std::move(tokens)), certificates_(certificates) {}

  /// UNAUTHENTICATED says what is missing or wrong, and nothing of who is known.
  absl::StatusOr<Identity> Identify(const Credentials& credentials) const;

 private:
  std::unique_ptr<TokenFile> tokens_;
  bool certificates_ = false;
};

}  // namespace celt::auth
