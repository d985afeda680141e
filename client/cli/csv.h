#pragma once

#include <string>
#include <vector>

namespace celt::cli {

/// A comma-separated line, cells quoted where they must be (RFC 4180), ended by a line feed.
std::string CsvLine(const std::vector<std::string>& cells);

}  // namespace celt::cli
