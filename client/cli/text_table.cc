#include "client/cli/text_table.h"

#include <algorithm>
#include <utility>

#include "client/cli/format.h"

namespace celt::cli {
namespace {

constexpr char kGap[] = " ";

/// A minus sign hangs in the gap before its column, so that the digits align.
bool IsNegative(const std::string& cell) { return cell.starts_with('-'); }

}  // namespace

TextTable::TextTable(std::vector<std::string> header) {
  if (!header.empty()) rows_.push_back(std::move(header));
}

void TextTable::Add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }

std::string TextTable::Text() const {
  std::vector<int> widths;
  for (const auto& row : rows_) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], Width(row[i]) - (IsNegative(row[i]) ? 1 : 0));
    }
  }
  std::string text;
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += kGap + std::string(IsNegative(row[i]) ? "" : " ") + row[i];
      const int hanging = IsNegative(row[i]) ? 1 : 0;
      line.append(static_cast<std::size_t>(widths[i] + hanging - Width(row[i])), ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace celt::cli
