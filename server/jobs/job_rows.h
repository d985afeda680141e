#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "absl/status/statusor.h"
#include "server/jobs/database.h"
#include "server/jobs/job.h"
#include "server/jobs/store.h"

namespace celt::jobs {

/// Jobs as rows of the table `jobs`: the one place that knows its columns. A job's key in the other
/// tables is its serial number, which also tells its place in the order of creation.

/// A job and its serial number.
struct JobRow {
  std::int64_t serial = 0;
  Job job;
};

/// Columns of a query whose rows ToJobRow reads.
#define CELT_JOB_COLUMNS                                                                   \
  "serial, id, owner, specification, engine_version, state, work_done, work_total, "       \
  "work_unit, last_sequence, error_code, error_message, result, created, started, ended, " \
  "unit_seconds, dropped"

/// How many those are.
inline constexpr int kJobColumns = 18;

JobRow ToJobRow(const Row& row);

absl::Status InsertJob(Database& database, const Job& job);
/// NOT_FOUND when there is none.
absl::StatusOr<JobRow> FindJob(Database& database, std::string_view id);
/// The job to use in place of a new one like `job`: one that has succeeded before one that has not
/// ended, the newest of each.
absl::StatusOr<std::optional<JobRow>> FindSame(Database& database, const Job& job, Reuse reuse);

/// Nanoseconds since 1970.
std::int64_t ToNanos(absl::Time time);

}  // namespace celt::jobs
