#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "server/jobs/database.h"
#include "server/jobs/store.h"

namespace celt::jobs {

/// A JobStore in an SQLite file (write-ahead log) or in memory. Every call is one transaction. What
/// a call has committed survives the death of the process at any moment, and a power cut as
/// Synchronous says. One process at a time: see DataDir.
class SqliteStore final : public JobStore {
 public:
  /// `path` of a file, made if there is none, or ":memory:". Errors as of PrepareSchema.
  static absl::StatusOr<std::unique_ptr<SqliteStore>> Open(
      const std::string& path, Synchronous synchronous = Synchronous::kNormal);

  absl::StatusOr<Job> Create(const Job& job, std::string_view request_id, Reuse reuse,
                             const absl::Status& room) override;
  absl::StatusOr<std::optional<Job>> FindAnswer(const Job& job) const override;
  absl::StatusOr<Job> Get(std::string_view id) const override;
  absl::StatusOr<JobPage> List(const JobFilter& filter, int page_size,
                               std::string_view page_token) const override;
  absl::StatusOr<std::vector<Job>> Unfinished() const override;
  absl::Status Delete(std::string_view id) override;

  absl::StatusOr<StoreStats> Stats() const override;
  absl::StatusOr<bool> Retain(const Retention& retention, absl::Time now) override;
  absl::Status Restart(std::string_view id, std::int64_t engine_version) override;
  absl::Status MarkStarted(std::string_view id, absl::Time now) override;
  absl::Status MarkEnded(std::string_view id, JobState state, const absl::Status& error,
                         std::string_view result, absl::Time now) override;

  absl::Status Commit(std::string_view id, const UnitCommit& commit) override;
  absl::StatusOr<Progress> LoadProgress(std::string_view id) const override;

  absl::StatusOr<std::vector<StoredRecord>> Records(std::string_view id, std::int64_t after,
                                                    std::size_t max_bytes) const override;

 private:
  explicit SqliteStore(std::unique_ptr<Database> database) : database_(std::move(database)) {}

  mutable std::mutex mutex_;
  const std::unique_ptr<Database> database_;  // used under mutex_
};

}  // namespace celt::jobs
