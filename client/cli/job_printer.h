#pragma once

#include <vector>

#include "absl/status/status.h"
#include "celt/v1/job.pb.h"
#include "client/cli/terminal.h"

namespace celt::cli {

/// Prints jobs:
///   json   {"job":{...}} a line
///   csv    a header, a row for each
///   table  a row for each under a header, or with PrintOne a line for each property
class JobPrinter {
 public:
  JobPrinter(OutputFormat format, Terminal& terminal);

  /// May be called repeatedly; a header is printed once.
  absl::Status Print(const std::vector<v1::Job>& jobs);
  absl::Status PrintOne(const v1::Job& job);

 private:
  OutputFormat format_;
  Terminal& terminal_;
  bool header_printed_ = false;
};

}  // namespace celt::cli
