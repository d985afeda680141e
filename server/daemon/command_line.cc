#include "server/daemon/command_line.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <variant>
#include <vector>

#include "absl/status/status.h"

namespace celt::daemon {
namespace {

using config::Setting;

struct Flags {
  std::string file;
  std::vector<std::function<absl::Status()>> overrides;  // of the file, in order
};

template <class Value>
void AddOverride(CLI::App& app, const Setting& setting, Flags& flags) {
  const auto add = [setting, &flags](const Value& value) {
    flags.overrides.push_back([setting, value] { return setting.Set(value); });
  };
  app.add_option_function<Value>(setting.Flag(), add, setting.help);
}

void Declare(CLI::App& app, CommandLine& line, Flags& flags) {
  app.set_version_flag("--version", "celtd " CELT_VERSION);
  app.add_option("--config", flags.file, "TOML file; the other options win over it");
  app.add_flag("--check", line.check, "Only check the configuration");
  app.add_option("--new-token", line.new_token,
                 "Print a token for OWNER or OWNER:admin and its line in the file of tokens");
  for (const Setting& setting : config::SettingsOf(line.config)) {
    if (std::holds_alternative<std::string*>(setting.place)) {
      AddOverride<std::string>(app, setting, flags);
    } else if (std::holds_alternative<std::int64_t*>(setting.place)) {
      AddOverride<std::int64_t>(app, setting, flags);
    } else {
      AddOverride<double>(app, setting, flags);
    }
  }
}

absl::Status Configure(const Flags& flags, config::Config& config) {
  if (!flags.file.empty()) {
    absl::Status status = config::ReadFile(flags.file, config);
    if (!status.ok()) return status;
  }
  for (const auto& override_setting : flags.overrides) {
    absl::Status status = override_setting();
    if (!status.ok()) return status;
  }
  return config::Check(config);
}

}  // namespace

std::string DefaultDataDir() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && *state == '/') return std::string(state) + "/celtd";
  const char* home = std::getenv("HOME");
  return home == nullptr ? std::string() : std::string(home) + "/.local/state/celtd";
}

CommandLine ReadCommandLine(int argc, const char* const* argv) {
  CLI::App app("celtd: computes the dynamics of the Celtic stone and of other systems, over gRPC");
  CommandLine line;
  line.config.data_dir = DefaultDataDir();
  Flags flags;
  Declare(app, line, flags);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    line.exit = app.exit(error) == 0 ? EXIT_SUCCESS : kConfigurationWrong;
    return line;
  }
  if (!line.new_token.empty()) return line;
  if (const absl::Status status = Configure(flags, line.config); !status.ok()) {
    std::fprintf(stderr, "celtd: %s\n", std::string(status.message()).c_str());
    line.exit = kConfigurationWrong;
  }
  return line;
}

}  // namespace celt::daemon
