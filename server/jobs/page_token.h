#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "absl/status/statusor.h"

namespace celt::jobs {

/// Where the next page of a list of jobs begins: after the last job of the page before, by what its
/// owner knows of it anyway. Opaque to clients.
struct PageToken {
  std::int64_t created = 0;  ///< of that job, in nanoseconds since 1970
  std::uint32_t states = 0;  ///< the filter, one bit a state; a token is only good for its own
  std::string id;            ///< of that job
};

std::string Encode(const PageToken& token);
/// INVALID_ARGUMENT: not a token of ours.
absl::StatusOr<PageToken> DecodePageToken(std::string_view text);

}  // namespace celt::jobs
