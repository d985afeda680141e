#include "server/jobs/retention_rows.h"

#include "server/jobs/job_rows.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

/// The job that ended first, before `time`; 0 for none. Serial numbers begin with 1.
absl::StatusOr<std::int64_t> FirstEnded(Database& database, absl::Time time, bool with_records) {
  if (time == absl::InfinitePast()) return 0;
  return database.QueryInt(
      "SELECT serial FROM jobs WHERE ended < ? AND (NOT ? OR dropped < last_sequence) "
      "ORDER BY ended LIMIT 1",
      {ToNanos(time), std::int64_t{with_records}});
}

absl::Status DropRecords(Database& database, std::int64_t job) {
  CELT_RETURN_IF_ERROR(database.Run("DELETE FROM records WHERE job = ?", {job}));
  return database.Run("UPDATE jobs SET dropped = last_sequence WHERE serial = ?", {job});
}

}  // namespace

absl::StatusOr<std::int64_t> UsedBytes(Database& database) {
  CELT_ASSIGN_OR_RETURN(const std::int64_t pages, database.QueryInt("PRAGMA page_count", {}));
  CELT_ASSIGN_OR_RETURN(const std::int64_t free, database.QueryInt("PRAGMA freelist_count", {}));
  CELT_ASSIGN_OR_RETURN(const std::int64_t size, database.QueryInt("PRAGMA page_size", {}));
  return (pages - free) * size;
}

absl::StatusOr<bool> RetainSome(Database& database, const Retention& retention, absl::Time now) {
  CELT_ASSIGN_OR_RETURN(const std::int64_t old_job,
                        FirstEnded(database, now - retention.jobs, false));
  if (old_job != 0) {
    CELT_RETURN_IF_ERROR(database.Run("DELETE FROM jobs WHERE serial = ?", {old_job}));
    return true;
  }
  CELT_ASSIGN_OR_RETURN(const std::int64_t bytes, UsedBytes(database));
  const absl::Time before =
      bytes > retention.bytes ? now + absl::Seconds(1) : now - retention.records;
  CELT_ASSIGN_OR_RETURN(const std::int64_t with_records, FirstEnded(database, before, true));
  if (with_records == 0) return false;
  CELT_RETURN_IF_ERROR(DropRecords(database, with_records));
  return true;
}

}  // namespace celt::jobs
