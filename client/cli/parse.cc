#include "client/cli/parse.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"

namespace celt::cli {
namespace {

template <typename Number>
std::optional<Number> ReadAll(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

absl::Status Refuse(const std::string& text, const std::string& why) {
  return absl::InvalidArgumentError(absl::StrCat("'", text, "' ", why));
}

/// Doubles count every integer up to here.
constexpr double kLargestExact = 9007199254740992.0;

std::optional<std::int64_t> ReadExactDouble(const std::string& text) {
  const auto number = ReadAll<double>(text);
  if (!number || !(std::abs(*number) <= kLargestExact) || *number != std::floor(*number)) return {};
  return static_cast<std::int64_t>(*number);
}

}  // namespace

absl::StatusOr<double> ParseNumber(const std::string& text) {
  const auto number = ReadAll<double>(text);
  if (!number || !std::isfinite(*number)) return Refuse(text, "is no finite number");
  return *number;
}

absl::StatusOr<std::int64_t> ParseInteger(const std::string& text, std::int64_t lowest,
                                          std::int64_t highest) {
  auto number = ReadAll<std::int64_t>(text);
  if (!number) number = ReadExactDouble(text);
  if (!number || *number < lowest || *number > highest) {
    return Refuse(text, absl::StrCat("is no whole number from ", lowest, " to ", highest));
  }
  return *number;
}

absl::StatusOr<std::uint64_t> ParseUnsigned(const std::string& text) {
  const auto number = ReadAll<std::uint64_t>(text);
  if (!number) return Refuse(text, "is no whole number from 0 to 18446744073709551615");
  return *number;
}

absl::StatusOr<std::vector<double>> ParseNumbers(const std::string& text,
                                                 const std::vector<std::string>& names) {
  const std::vector<std::string> parts = absl::StrSplit(text, ',');
  if (!names.empty() && parts.size() != names.size()) {
    return Refuse(
        text, absl::StrCat("should be ", names.size(), " numbers: ", absl::StrJoin(names, ",")));
  }
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    const auto number = ParseNumber(part);
    if (!number.ok()) return Refuse(text, absl::StrCat("holds ", number.status().message()));
    numbers.push_back(*number);
  }
  return numbers;
}

absl::StatusOr<std::pair<std::string, double>> ParseAssignment(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) return Refuse(text, "is not name=number");
  const auto number = ParseNumber(text.substr(equals + 1));
  if (!number.ok()) return Refuse(text, absl::StrCat("holds ", number.status().message()));
  return std::pair(text.substr(0, equals), *number);
}

absl::StatusOr<std::string> ParseAddress(const std::string& text) {
  constexpr int kHighestPort = 65535;
  const std::size_t colon = text.rfind(':');
  const bool bracketed = text.starts_with('[') && text.substr(0, colon).ends_with(']');
  const bool has_host = colon != std::string::npos && colon > 0;
  if (!has_host || (!bracketed && text.find_first_of(":/ ") != colon)) {
    return Refuse(text, "is not HOST:PORT");
  }
  const auto port = ReadAll<int>(text.substr(colon + 1));
  if (!port || *port < 1 || *port > kHighestPort) {
    return Refuse(text, "is not HOST:PORT with a port from 1 to 65535");
  }
  return text;
}

}  // namespace celt::cli
