#pragma once

#include <memory>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt sweep --axis NAME=FROM:TO:NODES ... ANALYSIS ...`, with each of the analyses that a sweep
/// can do as a subcommand with its own options.
std::unique_ptr<Analysis> MakeSweep();

}  // namespace celt::cli
