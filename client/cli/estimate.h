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

/// "known already, by job 3f1c…; --fresh computes it anew".
std::string KnownText(const v1::Job& job);

/// What a job that was only tried would take. One that has an id has given the answer already, and
/// there is nothing to wait for:
///   json   {"job":{"spec":…,"estimate":…}}, or the job that gave the answer
///   csv    a header and a row; known_by is that job's id
///   table  a line for each number, or one that names that job
std::string EstimateReport(const v1::Job& job, OutputFormat format);

}  // namespace celt::cli
