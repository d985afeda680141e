#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "CLI/App.hpp"

namespace celt::cli {

// Options whose values are read strictly; a bad one raises CLI::ValidationError, which names the
// option, the value and what is allowed. The targets must outlive the parsing.

/// Text for help.
struct Help {
  std::string group;
  std::string value;  ///< what to write for the value, such as "N"
  std::string text;   ///< with unit and default
};

void AddNumber(CLI::App& app, const std::string& name, std::optional<double>& target,
               const Help& help);

/// What can be sent at all; which values make sense is for the service to say.
struct IntegerRange {
  std::int64_t lowest = 0;
  std::int64_t highest = std::numeric_limits<std::int64_t>::max();
};

void AddInteger(CLI::App& app, const std::string& name, std::optional<std::int64_t>& target,
                const Help& help, const IntegerRange& range = {});

void AddUnsigned(CLI::App& app, const std::string& name, std::optional<std::uint64_t>& target,
                 const Help& help);

/// As many numbers as `names`, or any number of them when that is empty.
void AddNumbers(CLI::App& app, const std::string& name, const std::vector<std::string>& names,
                std::optional<std::vector<double>>& target, const Help& help);

/// One of a few words; the target gets its index.
void AddChoice(CLI::App& app, const std::string& name, const std::vector<std::string>& words,
               std::optional<int>& target, const Help& help);

}  // namespace celt::cli
