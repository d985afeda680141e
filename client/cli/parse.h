#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"

namespace celt::cli {

// Strict readers of values: the whole text counts, no white space. An error is INVALID_ARGUMENT
// with a message such as "'1e3x' is no finite number".

/// A finite decimal number.
absl::StatusOr<double> ParseNumber(const std::string& text);

/// A whole number in [lowest, highest]; "1e6" is one, "1.5" and "1e300" are not.
absl::StatusOr<std::int64_t> ParseInteger(const std::string& text, std::int64_t lowest,
                                          std::int64_t highest);

/// A whole number from 0 to 2^64 - 1, in digits.
absl::StatusOr<std::uint64_t> ParseUnsigned(const std::string& text);

/// Finite numbers separated by commas, exactly `names.size()` of them; any number of them, but at
/// least one, when there are no names.
absl::StatusOr<std::vector<double>> ParseNumbers(const std::string& text,
                                                 const std::vector<std::string>& names);

/// "name=number".
absl::StatusOr<std::pair<std::string, double>> ParseAssignment(const std::string& text);

/// "host:port" with a port from 1 to 65535; the host may be "[v6 address]".
absl::StatusOr<std::string> ParseAddress(const std::string& text);

}  // namespace celt::cli
