#include "server/auth/gate.h"

#include <optional>

#include "absl/status/status.h"

namespace celt::auth {
namespace {

constexpr std::string_view kScheme = "Bearer ";

}  // namespace

absl::StatusOr<Identity> Gate::Identify(const Credentials& credentials) const {
  if (tokens_ == nullptr && !certificates_) return Identity{.owner = "", .admin = true};
  if (tokens_ != nullptr && !credentials.authorization.empty()) {
    if (!credentials.authorization.starts_with(kScheme)) {
      return absl::UnauthenticatedError("authorization: is not 'Bearer TOKEN'");
    }
    std::optional<Identity> identity =
        tokens_->Find(credentials.authorization.substr(kScheme.size()));
    if (identity) return *std::move(identity);
    return absl::UnauthenticatedError("authorization: this server does not know the token");
  }
  if (certificates_ && !credentials.common_name.empty()) {
    return Identity{.owner = std::string(credentials.common_name), .admin = false};
  }
  return absl::UnauthenticatedError(tokens_ != nullptr
                                        ? "authorization: missing; this server wants a token"
                                        : "this server wants a client certificate with a name");
}

}  // namespace celt::auth
