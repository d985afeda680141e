#pragma once

#include <optional>
#include <string>

#include "server/config/config.h"

namespace celt::daemon {

/// The configuration is wrong.
inline constexpr int kConfigurationWrong = 2;

/// What celtd is told.
struct CommandLine {
  config::Config config;
  bool check = false;     ///< only the configuration is asked about
  std::string new_token;  ///< "OWNER" or "OWNER:admin"; empty: none is wanted
  /// Nothing is left to do but to end with this code: help was asked for and given, or something
  /// was wrong and said.
  std::optional<int> exit;
};

/// Reads the arguments, and the configuration file that they name. Flags win over the file.
CommandLine ReadCommandLine(int argc, const char* const* argv);

/// By the XDG rules. Not the folder of the command line's own service, which may run beside this
/// one. Empty when the environment names none.
std::string DefaultDataDir();

}  // namespace celt::daemon
