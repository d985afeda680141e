#pragma once

#include <memory>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt fixed-point`.
std::unique_ptr<Analysis> MakeFixedPoint();

}  // namespace celt::cli
