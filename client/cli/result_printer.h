#pragma once

#include <string>

#include "absl/status/status.h"
#include "celt/v1/job.pb.h"
#include "client/cli/analysis.h"
#include "client/cli/terminal.h"

namespace celt::cli {

/// Prints the records and the result of one job in the format asked for:
///   json   {"sequence":"1","<analysis>":{...}} for each record, then {"result":{...}}
///   csv    a header, a row "record,<sequence>,..." for each record, then "result,,..."
///   table  a line for each record where the analysis has one, then the result for people
class ResultPrinter {
 public:
  /// All three must outlive the printer.
  ResultPrinter(OutputFormat format, const Analysis& analysis, Terminal& terminal);

  absl::Status Print(const v1::Record& record);
  absl::Status Print(const v1::Job& job, const v1::Result& result);

 private:
  absl::Status PrintLine(const std::string& line);
  absl::Status PrintRow(const CsvRow& row);

  OutputFormat format_;
  const Analysis& analysis_;
  Terminal& terminal_;
  bool header_printed_ = false;
};

}  // namespace celt::cli
