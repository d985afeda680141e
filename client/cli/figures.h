#pragma once

#include <string>

#include "client/cli/exit_code.h"
#include "client/cli/session.h"

namespace celt::cli {

/// Makes the paper's figures, the LMP graph and the bifurcation diagram in a folder: the data by
/// jobs of their own, the pictures by gnuplot. Says what went wrong; kInterrupted at Ctrl-C.
ExitCode MakeFigures(const Session& session, const std::string& folder);

}  // namespace celt::cli
