#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "absl/status/statusor.h"
#include "server/jobs/database.h"
#include "server/jobs/job.h"

namespace celt::jobs {

/// Jobs as rows of the table `jobs`: the one place that knows its columns. A job's key in the other
/// tables is its serial number, which also tells its place in the order of creation.

/// A job and its serial number.
struct JobRow {
  std::int64_t serial = 0;
  Job job;
};

/// Columns of a query whose rows ToJobRow reads.
#define CELT_JOB_COLUMNS                                                             \
  "serial, id, request_id, specification, state, work_done, work_total, work_unit, " \
  "last_sequence, error_code, error_message, result, created, started, ended"

JobRow ToJobRow(const Row& row);

absl::Status InsertJob(Database& database, const Job& job);
/// NOT_FOUND when there is none.
absl::StatusOr<JobRow> FindJob(Database& database, std::string_view id);
absl::StatusOr<std::optional<Job>> FindRequest(Database& database, std::string_view request_id);

/// Nanoseconds since 1970.
std::int64_t ToNanos(absl::Time time);

}  // namespace celt::jobs
