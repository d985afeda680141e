#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "client/cli/environment.h"
#include "client/cli/service_options.h"
#include "client/client.h"

namespace celt::cli {

/// How to encrypt. INVALID_ARGUMENT names the option whose file can't be read.
absl::StatusOr<client::ChannelSecurity> SecurityOf(const ServiceOptions& options,
                                                   const Environment& environment);

/// The token for the server at `address`: of --token-file, CELT_TOKEN_FILE or CELT_TOKEN, in this
/// order; empty for none. It is never taken from the command line, which others can see.
/// INVALID_ARGUMENT: the file can't be read, or the token would travel in clear to another machine.
absl::StatusOr<std::string> TokenFor(const std::string& address,
                                     const client::ChannelSecurity& security,
                                     const ServiceOptions& options, const Environment& environment);

}  // namespace celt::cli
