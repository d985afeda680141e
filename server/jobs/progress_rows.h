#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "server/jobs/database.h"
#include "server/jobs/store.h"

namespace celt::jobs {

/// Progress and records as rows of the tables `folds`, `chains`, `payloads` and `records`: the one
/// place that knows their columns. `job` is the job's serial number. The caller holds a transaction
/// where it writes.

absl::Status WriteProgress(Database& database, std::int64_t job, const UnitCommit& commit);
absl::StatusOr<Progress> ReadProgress(Database& database, std::int64_t job);
absl::Status DeleteProgress(Database& database, std::int64_t job);

absl::Status AppendRecords(Database& database, std::int64_t job, std::int64_t last_sequence,
                           const std::vector<std::string>& records);
/// As JobStore::Records.
absl::StatusOr<std::vector<StoredRecord>> ReadRecords(Database& database, std::int64_t job,
                                                      std::int64_t after, std::size_t max_bytes);

}  // namespace celt::jobs
