#pragma once

#include <memory>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt section`.
std::unique_ptr<Analysis> MakeSection();

}  // namespace celt::cli
