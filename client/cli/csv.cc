#include "client/cli/csv.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"

namespace celt::cli {

std::string CsvLine(const std::vector<std::string>& cells) {
  const auto write = [](std::string* line, const std::string& cell) {
    const bool plain = cell.find_first_of(",\"\r\n") == std::string::npos;
    absl::StrAppend(
        line, plain ? cell : absl::StrCat("\"", absl::StrReplaceAll(cell, {{"\"", "\"\""}}), "\""));
  };
  return absl::StrJoin(cells, ",", write) + "\n";
}

}  // namespace celt::cli
