#pragma once

#include <memory>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt orbit`.
std::unique_ptr<Analysis> MakeOrbit();

}  // namespace celt::cli
