#pragma once

#include <string>
#include <vector>

#include "client/cli/environment.h"

namespace celt::cli {

/// Runs `celt` with these arguments (without the program's name) and returns the exit code.
int Run(const std::vector<std::string>& arguments, const Environment& environment);

}  // namespace celt::cli
