#pragma once

namespace celt::jobs {

/// Payloads of a status that say to a program what its message says to a person.

/// The id of the job that is in the way of a new one.
inline constexpr const char* kExistingJobPayload = "celt.v1/existing-job";

/// After how many seconds it is worth while to try again.
inline constexpr const char* kRetrySecondsPayload = "celt.v1/retry-seconds";

}  // namespace celt::jobs
