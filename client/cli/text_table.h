#pragma once

#include <string>
#include <vector>

namespace celt::cli {

/// Columns of text, aligned to the left and indented by two; estimates align at their points.
class TextTable {
 public:
  /// No header line when `header` is empty.
  explicit TextTable(std::vector<std::string> header);

  void Add(std::vector<std::string> row);
  /// Lines, each ended.
  std::string Text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace celt::cli
