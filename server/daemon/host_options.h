#pragma once

#include "server/config/config.h"
#include "server/host/host.h"

namespace celt::daemon {

/// A host as the configuration wants it, which tells the log what it has to tell.
host::HostOptions HostOptionsOf(const config::Config& config);

}  // namespace celt::daemon
