#pragma once

#include <string>

#include "celt/v1/job.pb.h"

namespace celt::cli {

/// Cycles for people. One found from a guess: points, multipliers, residual, the paper's test.
/// Those of a search: a block for each, what they have to do with each other, and how the starts
/// ended.
std::string FixedPointTable(const v1::JobSpec& spec, const v1::FixedPointResult& result);

}  // namespace celt::cli
