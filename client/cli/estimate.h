#pragma once

#include <string>

#include "absl/time/time.h"
#include "celt/v1/job.pb.h"
#include "client/cli/terminal.h"

namespace celt::cli {

/// How long it is until a job ends, at the latest as far as is known.
absl::Duration UntilEnd(const v1::Estimate& estimate);

/// "about 1:05: 216 000 iterates in 135 units; 0:30 of other jobs before or beside it".
std::string EstimateText(const v1::Estimate& estimate);

/// What a job that was only tried would take:
///   json   {"job":{"spec":…,"estimate":…}}
///   csv    a header and a row
///   table  a line for each number
std::string EstimateReport(const v1::Job& job, OutputFormat format);

}  // namespace celt::cli
