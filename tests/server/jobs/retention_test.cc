// What a store keeps of jobs that have ended.

#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/store_testing.h"

namespace celt::jobs {
namespace {

using ::testing::SizeIs;

class RetentionTest : public SqliteStoreTest {
 protected:
  /// A job with three records that ended at `ended`.
  void AddEndedAt(const std::string& id, absl::Time ended, std::size_t record_size = 10) {
    Add(id);
    UnitCommit commit;
    commit.records.assign(3, std::string(record_size, 'r'));
    ASSERT_TRUE(store_->Commit(id, commit).ok());
    ASSERT_TRUE(store_->MarkEnded(id, JobState::kSucceeded, {}, "result", ended).ok());
  }
  void Keep(const Retention& retention) {
    for (bool more = true; more;) {
      const auto kept = store_->Retain(retention, kNow);
      ASSERT_TRUE(kept.ok()) << kept.status();
      more = *kept;
    }
  }
  bool HasRecords(const std::string& id) const {
    const auto records = store_->Records(id, 0, kPlenty);
    EXPECT_TRUE(records.ok() || absl::IsOutOfRange(records.status())) << records.status();
    return records.ok();
  }
};

TEST_F(RetentionTest, KeepsEverythingByDefault) {
  AddEndedAt("old", kNow - absl::Hours(1'000'000));
  Keep({});
  EXPECT_TRUE(HasRecords("old"));
}

TEST_F(RetentionTest, DropsOldRecordsAndKeepsTheResult) {
  AddEndedAt("old", kNow - absl::Hours(3));
  AddEndedAt("new", kNow - absl::Hours(1));
  Add("running");
  Retention retention;
  retention.records = absl::Hours(2);
  Keep(retention);
  EXPECT_TRUE(HasRecords("new"));
  EXPECT_TRUE(HasRecords("running"));
  EXPECT_EQ(store_->Get("old")->result, "result");
  EXPECT_EQ(store_->Get("old")->dropped, 3);
  const absl::Status dropped = store_->Records("old", 2, kPlenty).status();
  EXPECT_TRUE(absl::IsOutOfRange(dropped));
  EXPECT_THAT(std::string(dropped.message()), ::testing::HasSubstr("after_sequence: 2"));
  EXPECT_THAT(*store_->Records("old", 3, kPlenty), SizeIs(0)) << "who has seen all misses nothing";
}

TEST_F(RetentionTest, ServesNoAnswerWhoseRecordsAreGone) {
  AddEndedAt("old", kNow - absl::Hours(3));
  Retention retention;
  retention.records = absl::Hours(2);
  Keep(retention);
  EXPECT_EQ(store_->Create(NewJob("new"), "", Reuse::kAnswers, absl::OkStatus())->id, "new");
}

TEST_F(RetentionTest, DeletesOldJobs) {
  AddEndedAt("old", kNow - absl::Hours(3));
  AddEndedAt("new", kNow - absl::Hours(1));
  Add("running");
  Retention retention;
  retention.jobs = absl::Hours(2);
  Keep(retention);
  EXPECT_TRUE(absl::IsNotFound(store_->Get("old").status()));
  EXPECT_TRUE(store_->Get("new").ok());
  EXPECT_TRUE(store_->Get("running").ok());
}

TEST_F(RetentionTest, AboveItsSizeDropsTheRecordsOfThoseThatEndedFirst) {
  constexpr std::size_t kRecord = 100'000;
  AddEndedAt("second", kNow - absl::Hours(2), kRecord);
  AddEndedAt("first", kNow - absl::Hours(3), kRecord);
  AddEndedAt("third", kNow - absl::Hours(1), kRecord);
  Retention retention;
  retention.bytes = 7 * kRecord;
  Keep(retention);
  EXPECT_FALSE(HasRecords("first"));
  EXPECT_TRUE(HasRecords("second"));
  EXPECT_TRUE(HasRecords("third"));
  EXPECT_LE(store_->Stats()->bytes, retention.bytes);
}

TEST_F(RetentionTest, EndsWhenThereIsNothingLeftToDrop) {
  AddEndedAt("a", kNow - absl::Hours(1), 100'000);
  Retention retention;
  retention.bytes = 1;
  Keep(retention);
  EXPECT_FALSE(HasRecords("a"));
  EXPECT_GT(store_->Stats()->bytes, 1);
}

TEST_F(RetentionTest, CountsJobsByState) {
  AddEndedAt("a", kNow);
  Add("b");
  Add("c");
  const auto stats = store_->Stats();
  ASSERT_TRUE(stats.ok());
  EXPECT_EQ(stats->jobs.at(JobState::kSucceeded), 1);
  EXPECT_EQ(stats->jobs.at(JobState::kQueued), 2);
}

}  // namespace
}  // namespace celt::jobs
