#include "server/jobs/job_rows.h"

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

absl::Time TimeAt(const Row& row, int column) {
  return row.IsNull(column) ? absl::InfinitePast() : absl::FromUnixNanos(row.Int(column));
}

Value TimeOrNull(absl::Time time) {
  if (time == absl::InfinitePast()) return nullptr;
  return ToNanos(time);
}

}  // namespace

std::int64_t ToNanos(absl::Time time) { return absl::ToUnixNanos(time); }

JobRow ToJobRow(const Row& row) {
  JobRow result;
  int column = 0;
  result.serial = row.Int(column++);
  Job& job = result.job;
  job.id = row.Bytes(column++);
  job.owner = row.Bytes(column++);
  job.specification = row.Bytes(column++);
  job.engine_version = row.Int(column++);
  job.state = static_cast<JobState>(row.Int(column++));
  job.work_done = row.Real(column++);
  job.work_total = row.Real(column++);
  job.work_unit = row.Bytes(column++);
  job.last_sequence = row.Int(column++);
  const auto code = static_cast<absl::StatusCode>(row.Int(column++));
  job.error = absl::Status(code, row.Bytes(column++));
  job.result = row.Bytes(column++);
  job.created = TimeAt(row, column++);
  job.started = TimeAt(row, column++);
  job.ended = TimeAt(row, column++);
  job.unit_seconds = row.Real(column++);
  job.dropped = row.Int(column++);
  return result;
}

absl::Status InsertJob(Database& database, const Job& job) {
  const std::string message(job.error.message());
  return database.Run(
      "INSERT INTO jobs (id, owner, specification, engine_version, state, work_done, work_total, "
      "work_unit, last_sequence, error_code, error_message, result, created, started, ended) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      {std::string_view(job.id), std::string_view(job.owner), Blob{job.specification},
       job.engine_version, static_cast<std::int64_t>(job.state), job.work_done, job.work_total,
       std::string_view(job.work_unit), job.last_sequence,
       static_cast<std::int64_t>(job.error.code()), std::string_view(message), Blob{job.result},
       TimeOrNull(job.created), TimeOrNull(job.started), TimeOrNull(job.ended)});
}

absl::StatusOr<JobRow> FindJob(Database& database, std::string_view id) {
  std::optional<JobRow> found;
  CELT_RETURN_IF_ERROR(database.Query("SELECT " CELT_JOB_COLUMNS " FROM jobs WHERE id = ?", {id},
                                      [&](const Row& row) {
                                        found = ToJobRow(row);
                                        return false;
                                      }));
  if (!found) return absl::NotFoundError(absl::StrCat("id: there is no job ", std::string(id)));
  return *std::move(found);
}

absl::StatusOr<std::optional<JobRow>> FindSame(Database& database, const Job& job, Reuse reuse) {
  std::optional<JobRow> found;
  if (reuse == Reuse::kNothing) return found;
  const std::int64_t unfinished = reuse == Reuse::kAnswersAndUnfinished ? 1 : 0;
  CELT_RETURN_IF_ERROR(database.Query(
      "SELECT " CELT_JOB_COLUMNS
      " FROM jobs WHERE owner = ? AND specification = ? AND engine_version = ? "
      "AND dropped = 0 AND (state = 3 OR (? AND state IN (1, 2))) ORDER BY state DESC, serial DESC "
      "LIMIT 1",
      {std::string_view(job.owner), Blob{job.specification}, job.engine_version, unfinished},
      [&](const Row& row) {
        found = ToJobRow(row);
        return false;
      }));
  return found;
}

}  // namespace celt::jobs
