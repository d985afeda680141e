#include "server/daemon/new_token.h"

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "server/auth/tokens.h"

namespace celt::daemon {

absl::StatusOr<std::string> NewTokenText(const std::string& owner) {
  const std::size_t colon = owner.find(':');
  const bool admin = colon != std::string::npos && owner.substr(colon) == ":admin";
  const std::string name = owner.substr(0, colon);
  const bool good = (colon == std::string::npos || admin) && !name.empty() && name[0] != '#' &&
                    name.find_first_of(" \t\n") == std::string::npos;
  if (!good) {
    return absl::InvalidArgumentError(
        absl::StrCat("--new-token: '", owner, "' is not OWNER or OWNER:admin"));
  }
  const std::string token = auth::NewToken();
  return absl::StrCat("token, for its owner alone: ", token,
                      "\nline of the file of tokens:  ", auth::TokenLine({name, admin}, token),
                      "\n");
}

}  // namespace celt::daemon
