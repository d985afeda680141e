#pragma once

#include <string>

#include "celt/v1/job.pb.h"

namespace celt::cli {

/// A point of a branch, or a bifurcation, as a line under the header that the first one has.
std::string ContinuationLine(const v1::Record& record);

/// The bifurcations and the ends, in a line.
std::string ContinuationBrief(const v1::ContinuationResult& result);

/// The bifurcations, what is known of each, and how the branches ended.
std::string ContinuationTable(const v1::JobSpec& spec, const v1::ContinuationResult& result);

}  // namespace celt::cli
