#include "client/cli/result_printer.h"

#include "absl/strings/str_cat.h"
#include "client/cli/csv.h"
#include "client/cli/json.h"

namespace celt::cli {

ResultPrinter::ResultPrinter(OutputFormat format, const Analysis& analysis, Terminal& terminal)
    : format_(format), analysis_(analysis), terminal_(terminal) {}

absl::Status ResultPrinter::Print(const v1::Record& record) {
  if (format_ == OutputFormat::kTable) return PrintLine(analysis_.Line(record));
  if (format_ == OutputFormat::kJson) return terminal_.Write(ToJson(record) + "\n");
  CsvRow row = analysis_.Csv(record);
  row.insert(row.begin(), {{"row", "record"}, {"sequence", absl::StrCat(record.sequence())}});
  return PrintRow(row);
}

absl::Status ResultPrinter::Print(const v1::Job& job, const v1::Result& result) {
  if (format_ == OutputFormat::kTable) return terminal_.Write(analysis_.Table(job, result));
  if (format_ == OutputFormat::kJson) return terminal_.Write(ResultJson(result) + "\n");
  CsvRow row = analysis_.Csv(result);
  if (row.empty()) return absl::OkStatus();
  row.insert(row.begin(), {{"row", "result"}, {"sequence", ""}});
  return PrintRow(row);
}

absl::Status ResultPrinter::PrintLine(const std::string& line) {
  return line.empty() ? absl::OkStatus() : terminal_.Write(line);
}

absl::Status ResultPrinter::PrintRow(const CsvRow& row) {
  std::vector<std::string> header;
  std::vector<std::string> cells;
  for (const auto& [column, cell] : row) {
    header.push_back(column);
    cells.push_back(cell);
  }
  std::string text = header_printed_ ? "" : CsvLine(header);
  header_printed_ = true;
  return terminal_.Write(text + CsvLine(cells));
}

}  // namespace celt::cli
