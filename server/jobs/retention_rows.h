#pragma once

#include <cstdint>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "server/jobs/database.h"
#include "server/jobs/store.h"

namespace celt::jobs {

/// Bytes of the pages that are in use.
absl::StatusOr<std::int64_t> UsedBytes(Database& database);

/// Drops one job, or the records of one, that need not be kept; true when there was one. The caller
/// holds a transaction.
absl::StatusOr<bool> RetainSome(Database& database, const Retention& retention, absl::Time now);

}  // namespace celt::jobs
