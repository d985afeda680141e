#pragma once

#include <memory>

#include "client/cli/analysis.h"

namespace celt::cli {

/// `celt manifold`.
std::unique_ptr<Analysis> MakeManifold();

}  // namespace celt::cli
