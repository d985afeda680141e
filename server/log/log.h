#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace celt::log {

enum class Level { kDebug, kInfo, kWarning, kError, kCritical };

/// Names with values; those without a value are left out.
using Fields = std::vector<std::pair<std::string_view, std::string>>;

/// Where lines go, and which: to standard error; data has standard output for itself. `level` and
/// `format` as in the configuration. Before that, nothing is written.
void SetUp(const std::string& level, const std::string& format);

/// One line: what happened, and its fields. A value is cut after a thousand characters. Never waits
/// for who reads standard error: while they do not, lines are lost, and a line says how many. Safe
/// to use from many threads.
void Write(Level level, std::string_view event, const Fields& fields = {});

/// The line's content, "event name=value name="a value"" or the inside of a JSON object.
std::string AsText(std::string_view event, const Fields& fields);
std::string AsJson(std::string_view event, const Fields& fields);

}  // namespace celt::log
