#pragma once

#include <memory>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "gtest/gtest.h"
#include "server/jobs/sqlite_store.h"
#include "temporary_directory.h"

namespace celt::jobs {

inline constexpr std::size_t kPlenty = 1 << 20;
// Not a whole second, so that a store that drops the fraction shows.
inline const absl::Time kNow = absl::FromUnixNanos(1'700'000'000'123'456'789);

inline Job NewJob(const std::string& id) {
  Job job;
  job.id = id;
  job.specification = std::string("spec\0with a zero", 16);
  job.work_total = 12.5;
  job.work_unit = "units";
  job.created = kNow;
  return job;
}

inline void ExpectSame(const Job& a, const Job& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.owner, b.owner);
  EXPECT_EQ(a.engine_version, b.engine_version);
  EXPECT_EQ(a.specification, b.specification);
  EXPECT_EQ(a.state, b.state);
  EXPECT_EQ(a.work_done, b.work_done);
  EXPECT_EQ(a.work_total, b.work_total);
  EXPECT_EQ(a.work_unit, b.work_unit);
  EXPECT_EQ(a.last_sequence, b.last_sequence);
  EXPECT_EQ(a.error, b.error);
  EXPECT_EQ(a.result, b.result);
  EXPECT_EQ(a.created, b.created);
  EXPECT_EQ(a.started, b.started);
  EXPECT_EQ(a.ended, b.ended);
}

inline std::vector<std::string> Ids(const std::vector<Job>& jobs) {
  std::vector<std::string> ids;
  for (const Job& job : jobs) ids.push_back(job.id);
  return ids;
}

inline std::vector<std::string> Bytes(const std::vector<StoredRecord>& records) {
  std::vector<std::string> bytes;
  for (const StoredRecord& record : records) {
    bytes.push_back(absl::StrCat(record.sequence, ":", record.bytes));
  }
  return bytes;
}

inline UnitCommit FirstCommit() {
  UnitCommit commit;
  commit.position = {.chain = 1, .next_step = 1, .checkpoint = "one", .ended = false};
  commit.added = {{UnitId{0, 1}, "waits"}};
  commit.work_done = 1;
  return commit;
}

inline UnitCommit SecondCommit() {
  UnitCommit commit;
  commit.position = {.chain = 0, .next_step = 1, .checkpoint = "zero", .ended = true};
  commit.collected = {{0, 1}};
  commit.fold_state = "folded";
  commit.fold_next = {1, 1};
  commit.records = {"x", "yy", "zzz"};
  commit.work_done = 2;
  return commit;
}

/// A store in a file.
class SqliteStoreTest : public ::testing::Test {
 protected:
  SqliteStoreTest() { Open(); }

  void Open() {
    store_.reset();
    auto store = SqliteStore::Open(temporary_ / "jobs.sqlite");
    ASSERT_TRUE(store.ok()) << store.status();
    store_ = *std::move(store);
  }
  void Add(const std::string& id) {
    ASSERT_TRUE(store_->Create(NewJob(id), "", Reuse::kNothing, absl::OkStatus()).ok());
  }

  void AddEnded(const std::string& id, JobState state) {
    Add(id);
    ASSERT_TRUE(store_->MarkEnded(id, state, {}, "result", kNow).ok());
  }

  TemporaryDirectory temporary_;
  std::unique_ptr<SqliteStore> store_;
};

}  // namespace celt::jobs
