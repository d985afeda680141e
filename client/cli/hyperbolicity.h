#pragma once

#include <memory>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt hyperbolicity`.
std::unique_ptr<Analysis> MakeHyperbolicity();

}  // namespace celt::cli
