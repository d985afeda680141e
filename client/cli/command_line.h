#pragma once

#include <string>
#include <vector>

#include "CLI/App.hpp"
#include "absl/status/statusor.h"
#include "client/cli/analysis.h"
#include "client/cli/command.h"
#include "client/cli/service_options.h"

namespace celt::cli {

/// The tree of commands with their options.
class CommandLine {
 public:
  CommandLine();

  /// The command that the arguments name, its options read; null when they ask for a text (help or
  /// the version). INVALID_ARGUMENT is one line that names what is wrong. To be called once.
  absl::StatusOr<Command*> Parse(std::vector<std::string> arguments);

  const ServiceOptions& service() const { return service_; }
  /// The text that was asked for.
  const std::string& text() const { return text_; }

 private:
  void Add(CLI::App& parent, std::unique_ptr<Command> command);
  void AddJobs();
  void AddServer();

  CLI::App app_;
  ServiceOptions service_;
  Analyses analyses_;
  std::vector<std::unique_ptr<Command>> commands_;
  Command* chosen_ = nullptr;
  std::string text_;
};

}  // namespace celt::cli
