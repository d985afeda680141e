#pragma once

#include "server/config/config.h"
#include "server/daemon/signals.h"

namespace celt::daemon {

/// Runs a server until a signal drains it; says on standard output where it listens. Gives the exit
/// code.
int Serve(const config::Config& config, const TerminationSignals& signals);

}  // namespace celt::daemon
