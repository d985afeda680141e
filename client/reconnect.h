#pragma once

#include <stop_token>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/time/time.h"

namespace celt::client {

/// One attempt at a stream; sets `progressed` as soon as anything arrives.
using Attempt = absl::FunctionRef<absl::Status(bool& progressed)>;

/// Repeats an attempt that breaks off, with growing pauses, until it ends otherwise, until a stop
/// is asked for (CANCELLED), or until for `patience` nothing has arrived (UNAVAILABLE).
absl::Status Reconnect(absl::Duration patience, const std::stop_token& stop, Attempt attempt);

}  // namespace celt::client
