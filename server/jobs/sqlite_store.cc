#include "server/jobs/sqlite_store.h"

#include <limits>
#include <utility>

#include "absl/strings/str_cat.h"
#include "server/jobs/job_rows.h"
#include "server/jobs/page_token.h"
#include "server/jobs/progress_rows.h"
#include "server/jobs/request_rows.h"
#include "server/jobs/retention_rows.h"
#include "server/jobs/schema.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

std::uint32_t StateBits(const JobFilter& filter) {
  std::uint32_t bits = 0;
  for (const JobState state : filter.states) bits |= 1U << static_cast<unsigned>(state);
  return bits;
}

Value OwnerOrNull(const JobFilter& filter) {
  if (!filter.owner) return nullptr;
  return std::string_view(*filter.owner);
}

absl::StatusOr<PageToken> FirstOrNext(const JobFilter& filter, std::string_view text) {
  const std::uint32_t states = StateBits(filter);
  if (text.empty()) return PageToken{std::numeric_limits<std::int64_t>::max(), states, ""};
  CELT_ASSIGN_OR_RETURN(const PageToken token, DecodePageToken(text));
  if (token.states == states) return token;
  return absl::InvalidArgumentError("page_token: given for another filter of states");
}

absl::Status HasEndedError(std::string_view id) {
  return absl::FailedPreconditionError(absl::StrCat("job ", std::string(id), " has ended"));
}

}  // namespace

absl::StatusOr<std::unique_ptr<SqliteStore>> SqliteStore::Open(const std::string& path,
                                                               Synchronous synchronous) {
  CELT_ASSIGN_OR_RETURN(std::unique_ptr<Database> database, Database::Open(path));
  CELT_RETURN_IF_ERROR(PrepareSchema(*database, synchronous));
  return std::unique_ptr<SqliteStore>(new SqliteStore(std::move(database)));
}

absl::StatusOr<Job> SqliteStore::Create(const Job& job, std::string_view request_id, Reuse reuse,
                                        const absl::Status& room) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(*database_);
  CELT_RETURN_IF_ERROR(transaction.Begin());
  const Request request{job.owner, std::string(request_id), reuse};
  CELT_ASSIGN_OR_RETURN(std::optional<JobRow> row, FindRequest(*database_, request, job));
  if (row) return std::move(row->job);
  CELT_ASSIGN_OR_RETURN(row, FindSame(*database_, job, reuse));
  if (!row) {
    CELT_RETURN_IF_ERROR(room);
    CELT_RETURN_IF_ERROR(InsertJob(*database_, job));
    row = JobRow{database_->LastRowId(), job};
  }
  CELT_RETURN_IF_ERROR(InsertRequest(*database_, request, row->serial));
  CELT_RETURN_IF_ERROR(transaction.Commit());
  return std::move(row->job);
}

absl::StatusOr<std::optional<Job>> SqliteStore::FindAnswer(const Job& job) const {
  const std::lock_guard lock(mutex_);
  CELT_ASSIGN_OR_RETURN(const std::optional<JobRow> row,
                        FindSame(*database_, job, Reuse::kAnswers));
  if (!row) return std::nullopt;
  return row->job;
}

absl::StatusOr<Job> SqliteStore::Get(std::string_view id) const {
  const std::lock_guard lock(mutex_);
  CELT_ASSIGN_OR_RETURN(JobRow row, FindJob(*database_, id));
  return std::move(row.job);
}

absl::StatusOr<JobPage> SqliteStore::List(const JobFilter& filter, int page_size,
                                          std::string_view page_token) const {
  CELT_ASSIGN_OR_RETURN(const PageToken from, FirstOrNext(filter, page_token));
  const std::lock_guard lock(mutex_);
  JobPage page;
  // One row more than asked for tells whether there is a next page.
  CELT_RETURN_IF_ERROR(database_->Query(
      "SELECT " CELT_JOB_COLUMNS
      " FROM jobs WHERE created <= ?1 AND (created < ?1 OR serial < "
      "ifnull((SELECT serial FROM jobs WHERE id = ?5), 0)) "
      "AND (?2 = 0 OR (?2 >> state) & 1) "
      "AND (?4 IS NULL OR owner = ?4) ORDER BY created DESC, serial DESC LIMIT ?3",
      {from.created, std::int64_t{from.states}, std::int64_t{page_size} + 1, OwnerOrNull(filter),
       std::string_view(from.id)},
      [&](const Row& row) {
        if (std::ssize(page.jobs) == page_size) {
          const Job& last = page.jobs.back();
          page.next_page_token = Encode({ToNanos(last.created), from.states, last.id});
          return false;
        }
        page.jobs.push_back(ToJobRow(row).job);
        return true;
      }));
  return page;
}

absl::StatusOr<std::vector<Job>> SqliteStore::Unfinished() const {
  const std::lock_guard lock(mutex_);
  std::vector<Job> jobs;
  CELT_RETURN_IF_ERROR(database_->Query("SELECT " CELT_JOB_COLUMNS
                                        " FROM jobs WHERE state IN (1, 2) ORDER BY serial",
                                        {}, [&](const Row& row) {
                                          jobs.push_back(ToJobRow(row).job);
                                          return true;
                                        }));
  return jobs;
}

absl::Status SqliteStore::Delete(std::string_view id) {
  const std::lock_guard lock(mutex_);
  CELT_RETURN_IF_ERROR(database_->Run("DELETE FROM jobs WHERE id = ?", {id}));
  if (database_->Changes() > 0) return absl::OkStatus();
  return absl::NotFoundError(absl::StrCat("id: there is no job ", std::string(id)));
}

absl::StatusOr<StoreStats> SqliteStore::Stats() const {
  const std::lock_guard lock(mutex_);
  StoreStats stats;
  CELT_RETURN_IF_ERROR(
      database_->Query("SELECT state, count(*) FROM jobs GROUP BY state", {}, [&](const Row& row) {
        stats.jobs[static_cast<JobState>(row.Int(0))] = row.Int(1);
        return true;
      }));
  CELT_ASSIGN_OR_RETURN(stats.bytes, UsedBytes(*database_));
  CELT_ASSIGN_OR_RETURN(const std::int64_t synchronous,
                        database_->QueryInt("PRAGMA synchronous", {}));
  stats.synchronous = static_cast<Synchronous>(synchronous);
  return stats;
}

absl::StatusOr<bool> SqliteStore::Retain(const Retention& retention, absl::Time now) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(*database_);
  CELT_RETURN_IF_ERROR(transaction.Begin());
  CELT_ASSIGN_OR_RETURN(const bool more, RetainSome(*database_, retention, now));
  CELT_RETURN_IF_ERROR(transaction.Commit());
  return more;
}

absl::Status SqliteStore::Restart(std::string_view id, std::int64_t engine_version) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(*database_);
  CELT_RETURN_IF_ERROR(transaction.Begin());
  CELT_ASSIGN_OR_RETURN(const JobRow row, FindJob(*database_, id));
  if (HasEnded(row.job.state)) return HasEndedError(id);
  CELT_RETURN_IF_ERROR(DeleteProgress(*database_, row.serial));
  CELT_RETURN_IF_ERROR(database_->Run("DELETE FROM records WHERE job = ?", {row.serial}));
  CELT_RETURN_IF_ERROR(
      database_->Run("UPDATE jobs SET engine_version = ?, state = 1, work_done = 0, unit_seconds = "
                     "0, last_sequence = 0, "
                     "started = NULL WHERE serial = ?",
                     {engine_version, row.serial}));
  return transaction.Commit();
}

absl::Status SqliteStore::MarkStarted(std::string_view id, absl::Time now) {
  const std::lock_guard lock(mutex_);
  CELT_ASSIGN_OR_RETURN(const JobRow row, FindJob(*database_, id));
  if (row.job.state != JobState::kQueued) return absl::OkStatus();
  return database_->Run("UPDATE jobs SET state = 2, started = ? WHERE serial = ?",
                        {ToNanos(now), row.serial});
}

absl::Status SqliteStore::MarkEnded(std::string_view id, JobState state, const absl::Status& error,
                                    std::string_view result, absl::Time now) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(*database_);
  CELT_RETURN_IF_ERROR(transaction.Begin());
  CELT_ASSIGN_OR_RETURN(const JobRow row, FindJob(*database_, id));
  if (HasEnded(row.job.state)) return HasEndedError(id);
  const std::string message(error.message());
  CELT_RETURN_IF_ERROR(database_->Run(
      "UPDATE jobs SET state = ?, error_code = ?, error_message = ?, result = ?, ended = ? "
      "WHERE serial = ?",
      {static_cast<std::int64_t>(state), static_cast<std::int64_t>(error.code()),
       std::string_view(message), Blob{result}, ToNanos(now), row.serial}));
  CELT_RETURN_IF_ERROR(DeleteProgress(*database_, row.serial));
  return transaction.Commit();
}

absl::Status SqliteStore::Commit(std::string_view id, const UnitCommit& commit) {
  const std::lock_guard lock(mutex_);
  Transaction transaction(*database_);
  CELT_RETURN_IF_ERROR(transaction.Begin());
  CELT_ASSIGN_OR_RETURN(const JobRow row, FindJob(*database_, id));
  if (HasEnded(row.job.state)) return HasEndedError(id);
  CELT_RETURN_IF_ERROR(WriteProgress(*database_, row.serial, commit));
  CELT_RETURN_IF_ERROR(
      AppendRecords(*database_, row.serial, row.job.last_sequence, commit.records));
  CELT_RETURN_IF_ERROR(database_->Run(
      "UPDATE jobs SET work_done = ?, unit_seconds = ?, last_sequence = last_sequence + ? "
      "WHERE serial = ?",
      {commit.work_done, commit.unit_seconds, std::ssize(commit.records), row.serial}));
  return transaction.Commit();
}

absl::StatusOr<Progress> SqliteStore::LoadProgress(std::string_view id) const {
  const std::lock_guard lock(mutex_);
  CELT_ASSIGN_OR_RETURN(const JobRow row, FindJob(*database_, id));
  return ReadProgress(*database_, row.serial);
}

absl::StatusOr<std::vector<StoredRecord>> SqliteStore::Records(std::string_view id,
                                                               std::int64_t after,
                                                               std::size_t max_bytes) const {
  if (after < 0) {
    return absl::InvalidArgumentError(
        absl::StrCat("after_sequence: ", after, " is not allowed; it is 0 or a record's number"));
  }
  const std::lock_guard lock(mutex_);
  CELT_ASSIGN_OR_RETURN(const JobRow row, FindJob(*database_, id));
  if (after < row.job.dropped) {
    return absl::OutOfRangeError(absl::StrCat("after_sequence: ", after,
                                              " is too early; records up to ", row.job.dropped,
                                              " were dropped, the job is to be submitted anew"));
  }
  return ReadRecords(*database_, row.serial, after, max_bytes);
}

}  // namespace celt::jobs
