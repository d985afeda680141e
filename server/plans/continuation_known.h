#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "celt/v1/continuation.pb.h"

namespace celt::plans {

/// Adds what a unit found to what is known for the result (bytes; empty at first), whose points are
/// thinned by halves so that it stays one message of less than 4 MiB.
absl::StatusOr<std::string> FoldContinuation(std::string_view bytes,
                                             const v1::ContinuationResult& found);

absl::StatusOr<v1::ContinuationResult> KnownContinuation(std::string_view bytes);

}  // namespace celt::plans
