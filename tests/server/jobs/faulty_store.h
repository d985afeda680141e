#pragma once

#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "server/jobs/store.h"

namespace celt::jobs {

/// A store in which writing can be made to fail: `fault` is asked first, with the call's name.
class FaultyStore final : public JobStore {
 public:
  using Fault = std::function<absl::Status(std::string_view call)>;

  FaultyStore(JobStore& store, Fault fault) : store_(store), fault_(std::move(fault)) {}

  absl::StatusOr<Job> Create(const Job& job, std::string_view request_id, Reuse reuse,
                             const absl::Status& room) override {
    return store_.Create(job, request_id, reuse, room);
  }
  absl::StatusOr<std::optional<Job>> FindAnswer(const Job& job) const override {
    return store_.FindAnswer(job);
  }
  absl::StatusOr<Job> Get(std::string_view id) const override { return store_.Get(id); }
  absl::StatusOr<JobPage> List(const JobFilter& filter, int size,
                               std::string_view token) const override {
    return store_.List(filter, size, token);
  }
  absl::StatusOr<std::vector<Job>> Unfinished() const override { return store_.Unfinished(); }
  absl::Status Delete(std::string_view id) override { return store_.Delete(id); }
  absl::StatusOr<StoreStats> Stats() const override { return store_.Stats(); }
  absl::StatusOr<bool> Retain(const Retention& retention, absl::Time now) override {
    return store_.Retain(retention, now);
  }
  absl::Status Restart(std::string_view id, std::int64_t engine_version) override {
    const absl::Status fault = fault_("Restart");
    return fault.ok() ? store_.Restart(id, engine_version) : fault;
  }
  absl::Status MarkStarted(std::string_view id, absl::Time now) override {
    const absl::Status fault = fault_("MarkStarted");
    return fault.ok() ? store_.MarkStarted(id, now) : fault;
  }
  absl::Status MarkEnded(std::string_view id, JobState state, const absl::Status& error,
                         std::string_view result, absl::Time now) override {
    const absl::Status fault = fault_("MarkEnded");
    return fault.ok() ? store_.MarkEnded(id, state, error, result, now) : fault;
  }
  absl::Status Commit(std::string_view id, const UnitCommit& commit) override {
    const absl::Status fault = fault_("Commit");
    return fault.ok() ? store_.Commit(id, commit) : fault;
  }
  absl::StatusOr<Progress> LoadProgress(std::string_view id) const override {
    return store_.LoadProgress(id);
  }
  absl::StatusOr<std::vector<StoredRecord>> Records(std::string_view id, std::int64_t after,
                                                    std::size_t max_bytes) const override {
    return store_.Records(id, after, max_bytes);
  }

 private:
  JobStore& store_;
  Fault fault_;
};

}  // namespace celt::jobs
