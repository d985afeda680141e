#include "client/cli/format.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_format.h"

namespace celt::cli {
namespace {

/// Decimals beyond these are rounding of the sums, whatever the error says.
constexpr int kMostDecimals = 12;

std::string Fixed(double number, int decimals) { return absl::StrFormat("%.*f", decimals, number); }

}  // namespace

std::string Shortest(double number) {
  char buffer[32];
  const auto end = std::to_chars(std::begin(buffer), std::end(buffer), number).ptr;
  return {std::begin(buffer), end};
}

std::string Significant(double number, int digits) {
  return absl::StrFormat("%.*g", digits, number);
}

std::string WithError(double value, std::optional<double> error) {
  constexpr int kDigitsWithoutError = 6;
  if (!error || !(*error > 0)) return Significant(value, kDigitsWithoutError);
  // 0.000996 rounds to 0.0010: what counts is the exponent after rounding to two digits.
  const double rounded = std::stod(absl::StrFormat("%.1e", *error));
  const int decimals = 1 - static_cast<int>(std::floor(std::log10(rounded)));
  if (decimals > kMostDecimals) {
    return absl::StrCat(Fixed(value, kMostDecimals), " ± ", Significant(*error, 2));
  }
  const int shown = std::max(decimals, 0);
  return absl::StrCat(Fixed(value, shown), " ± ", Fixed(*error, shown));
}

std::string Grouped(std::int64_t number) {
  std::string digits = absl::StrCat(number);
  const int first = number < 0 ? 1 : 0;
  for (int i = static_cast<int>(digits.size()) - 3; i > first; i -= 3) {
    digits.insert(static_cast<std::size_t>(i), 1, ' ');  // as a count: GCC 12 warns of text
  }
  return digits;
}

std::string Clock(absl::Duration duration) {
  constexpr int kSixty = 60;
  const std::int64_t seconds = absl::ToInt64Seconds(duration + absl::Milliseconds(500));
  const std::int64_t minutes = seconds / kSixty;
  if (minutes < kSixty) return absl::StrFormat("%d:%02d", minutes, seconds % kSixty);
  return absl::StrFormat("%d:%02d:%02d", minutes / kSixty, minutes % kSixty, seconds % kSixty);
}

std::string SystemTitle(const v1::System& system) {
  const std::string name = system.name().empty() ? "celtic-stone" : system.name();
  const auto energy = system.parameters().find("energy");
  if (energy != system.parameters().end()) {
    return absl::StrCat(name, " at energy ", Shortest(energy->second));
  }
  const std::map<std::string, double> ordered(system.parameters().begin(),
                                              system.parameters().end());
  std::string title = name;
  const char* separator = ": ";
  for (const auto& [parameter, value] : ordered) {
    absl::StrAppend(&title, separator, parameter, " = ", Shortest(value));
    separator = ", ";
  }
  return title;
}

int Width(const std::string& text) {
  return static_cast<int>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & '\xC0') != '\x80'; }));
}

}  // namespace celt::cli
