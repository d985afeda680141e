#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "absl/time/time.h"
#include "celt/v1/system.pb.h"

namespace celt::cli {

/// The shortest text that reads back as the same number.
std::string Shortest(double number);

/// `number` to so many significant digits, as people write it.
std::string Significant(double number, int digits);

/// "0.01982 ± 0.00021": two digits of the error, and no more of the value than they support. An
/// error that is absent or 0 says nothing and is not shown.
std::string WithError(double value, std::optional<double> error);

/// "20 000".
std::string Grouped(std::int64_t number);

/// "0:07", "12:00", "3:04:05".
std::string Clock(absl::Duration duration);

/// "the Celtic stone at energy 752", "henon3d (B = 0.7)".
std::string SystemTitle(const v1::System& system);

/// Cells that a text takes on a terminal: its characters, in UTF-8.
int Width(const std::string& text);

}  // namespace celt::cli
