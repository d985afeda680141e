#pragma once

#include <memory>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt continue`.
std::unique_ptr<Analysis> MakeContinuation();

}  // namespace celt::cli
