#pragma once

#include <memory>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt reproduce`: the paper's table, and with --figures its figures.
std::unique_ptr<Analysis> MakeReproduce();

}  // namespace celt::cli
