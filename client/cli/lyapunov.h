#pragma once

#include <memory>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt lyapunov`.
std::unique_ptr<Analysis> MakeLyapunov();

}  // namespace celt::cli
