#pragma once

#include <optional>
#include <string>

#include "CLI/App.hpp"
#include "client/cli/environment.h"
#include "client/cli/terminal.h"

namespace celt::cli {

/// The options of every command: where the service is, and how to print.
struct ServiceOptions {
  std::optional<std::string> server;
  std::optional<std::string> token_file;
  bool tls = false;
  std::optional<std::string> tls_ca;
  std::optional<std::string> tls_certificate;
  std::optional<std::string> tls_key;
  std::optional<std::string> data_dir;
  std::optional<std::int64_t> threads;
  std::optional<double> reconnect;  ///< seconds
  std::optional<int> output;        ///< an OutputFormat

  /// Adds the options to a command; this object must outlive the parsing. May be called for
  /// several commands: `celt --server X jobs list` is `celt jobs list --server X`.
  void AddTo(CLI::App& app);

  OutputFormat Format(const Environment& environment) const;
  /// Address of the server; empty for the embedded service.
  std::string Server(const Environment& environment) const;
};

}  // namespace celt::cli
