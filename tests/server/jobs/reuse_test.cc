// What a store gives in place of a new job.

#include <string>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/store_testing.h"
#include "server/jobs/status_details.h"

namespace celt::jobs {
namespace {

using ::testing::IsEmpty;

using ReuseTest = SqliteStoreTest;

TEST_F(ReuseTest, GivesTheSameJobForTheSameRequest) {
  ASSERT_TRUE(store_->Create(NewJob("a"), "request", Reuse::kNothing, absl::OkStatus()).ok());
  Job again = NewJob("b");
  EXPECT_EQ(store_->Create(again, "request", Reuse::kNothing, absl::OkStatus())->id, "a");
  EXPECT_TRUE(absl::IsNotFound(store_->Get("b").status()));
  const absl::Status other_reuse =
      store_->Create(again, "request", Reuse::kAnswers, absl::OkStatus()).status();
  EXPECT_TRUE(absl::IsAlreadyExists(other_reuse));
  again.specification = "another";
  const absl::Status other_body =
      store_->Create(again, "request", Reuse::kNothing, absl::OkStatus()).status();
  EXPECT_TRUE(absl::IsAlreadyExists(other_body));
  EXPECT_EQ(other_body.GetPayload(kExistingJobPayload), "a");
}

TEST_F(ReuseTest, KeepsRequestsOfOwnersApart) {
  ASSERT_TRUE(store_->Create(NewJob("a"), "request", Reuse::kNothing, absl::OkStatus()).ok());
  Job others = NewJob("b");
  others.owner = "boris";
  others.specification = "another";
  EXPECT_EQ(store_->Create(others, "request", Reuse::kNothing, absl::OkStatus())->id, "b");
}

TEST_F(ReuseTest, RemembersARequestThatWasAnsweredFromTheStore) {
  AddEnded("a", JobState::kSucceeded);
  EXPECT_EQ(store_->Create(NewJob("b"), "request", Reuse::kAnswers, absl::OkStatus())->id, "a");
  Job other = NewJob("c");
  other.specification = "another";
  EXPECT_TRUE(absl::IsAlreadyExists(
      store_->Create(other, "request", Reuse::kAnswers, absl::OkStatus()).status()));
}

TEST_F(ReuseTest, ForgetsARequestWithItsJob) {
  ASSERT_TRUE(store_->Create(NewJob("a"), "request", Reuse::kNothing, absl::OkStatus()).ok());
  ASSERT_TRUE(store_->Delete("a").ok());
  EXPECT_EQ(store_->Create(NewJob("b"), "request", Reuse::kNothing, absl::OkStatus())->id, "b");
}

TEST_F(ReuseTest, FindsTheNewestAnswerToTheSameQuestion) {
  AddEnded("a", JobState::kSucceeded);
  AddEnded("b", JobState::kSucceeded);
  EXPECT_EQ(store_->Create(NewJob("c"), "", Reuse::kAnswers, absl::OkStatus())->id, "b");
  EXPECT_EQ(store_->Create(NewJob("d"), "", Reuse::kNothing, absl::OkStatus())->id, "d");
}

TEST_F(ReuseTest, TakesNoJobForAnAnswerThatHasNone) {
  AddEnded("failed", JobState::kFailed);
  AddEnded("cancelled", JobState::kCancelled);
  Add("queued");
  EXPECT_EQ(store_->Create(NewJob("new"), "", Reuse::kAnswers, absl::OkStatus())->id, "new");
}

TEST_F(ReuseTest, TakesNoAnswerOfAnotherOwnerOrEngineOrToAnotherQuestion) {
  AddEnded("a", JobState::kSucceeded);
  Job owned = NewJob("b");
  owned.owner = "boris";
  EXPECT_EQ(store_->Create(owned, "", Reuse::kAnswersAndUnfinished, absl::OkStatus())->id, "b");
  Job later = NewJob("c");
  later.engine_version = 1;
  EXPECT_EQ(store_->Create(later, "", Reuse::kAnswersAndUnfinished, absl::OkStatus())->id, "c");
  Job other = NewJob("d");
  other.specification += "!";
  EXPECT_EQ(store_->Create(other, "", Reuse::kAnswersAndUnfinished, absl::OkStatus())->id, "d");
}

TEST_F(ReuseTest, JoinsAnUnfinishedJobWhereAskedToAndNoEndedOne) {
  AddEnded("cancelled", JobState::kCancelled);
  Add("queued");
  EXPECT_EQ(store_->Create(NewJob("new"), "", Reuse::kAnswersAndUnfinished, absl::OkStatus())->id,
            "queued");
  AddEnded("answer", JobState::kSucceeded);
  Add("later");
  EXPECT_EQ(store_->Create(NewJob("new"), "", Reuse::kAnswersAndUnfinished, absl::OkStatus())->id,
            "answer");
}

TEST_F(ReuseTest, RestartsAJobAsIfNothingHadBeenComputed) {
  Add("a");
  ASSERT_TRUE(store_->MarkStarted("a", kNow).ok());
  ASSERT_TRUE(store_->Commit("a", FirstCommit()).ok());
  ASSERT_TRUE(store_->Restart("a", 5).ok());
  Job expected = NewJob("a");
  expected.engine_version = 5;
  ExpectSame(*store_->Get("a"), expected);
  EXPECT_THAT(*store_->Records("a", 0, kPlenty), IsEmpty());
  EXPECT_THAT(store_->LoadProgress("a")->chains, IsEmpty());
  ASSERT_TRUE(store_->MarkEnded("a", JobState::kSucceeded, {}, "result", kNow).ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(store_->Restart("a", 6)));
}

}  // namespace
}  // namespace celt::jobs
