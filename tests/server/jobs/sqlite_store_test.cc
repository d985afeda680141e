#include "server/jobs/sqlite_store.h"

#include <memory>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/store_testing.h"

namespace celt::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST_F(SqliteStoreTest, GivesBackAJobAsItWas) {
  Job job = NewJob("a");
  job.owner = "anna";
  job.engine_version = 7;
  ASSERT_TRUE(store_->Create(job, "request", Reuse::kNothing, absl::OkStatus()).ok());
  Open();
  const auto found = store_->Get("a");
  ASSERT_TRUE(found.ok()) << found.status();
  ExpectSame(*found, job);
}

TEST_F(SqliteStoreTest, KnowsNoJobThatWasNotCreated) {
  const std::string id = "nobody";
  EXPECT_TRUE(absl::IsNotFound(store_->Get(id).status()));
  EXPECT_TRUE(absl::IsNotFound(store_->Delete(id)));
  EXPECT_TRUE(absl::IsNotFound(store_->MarkStarted(id, kNow)));
  EXPECT_TRUE(absl::IsNotFound(store_->MarkEnded(id, JobState::kCancelled, {}, "", kNow)));
  EXPECT_TRUE(absl::IsNotFound(store_->Commit(id, {})));
  EXPECT_TRUE(absl::IsNotFound(store_->LoadProgress(id).status()));
  EXPECT_TRUE(absl::IsNotFound(store_->Records(id, 0, kPlenty).status()));
}

TEST_F(SqliteStoreTest, MakesANewJobOfEachSubmissionWithoutRequest) {
  Add("a");
  Add("b");
  EXPECT_TRUE(store_->Get("b").ok());
}

TEST_F(SqliteStoreTest, ListsTheNewestFirstPageByPage) {
  for (const char* id : {"a", "b", "c", "d", "e"}) Add(id);
  const auto first = store_->List({}, 2, "");
  ASSERT_TRUE(first.ok()) << first.status();
  EXPECT_THAT(Ids(first->jobs), ElementsAre("e", "d"));
  Add("f");  // comes between the pages, and must not shift them
  const auto second = store_->List({}, 2, first->next_page_token);
  EXPECT_THAT(Ids(second->jobs), ElementsAre("c", "b"));
  const auto third = store_->List({}, 2, second->next_page_token);
  EXPECT_THAT(Ids(third->jobs), ElementsAre("a"));
  EXPECT_EQ(third->next_page_token, "");
}

TEST_F(SqliteStoreTest, GoesOnWithAListThoughTheLastJobOfAPageWasDeleted) {
  for (int i = 0; i < 4; ++i) {
    Job job = NewJob(absl::StrCat("job", i));
    job.created += absl::Nanoseconds(i);
    ASSERT_TRUE(store_->Create(job, "", Reuse::kNothing, absl::OkStatus()).ok());
  }
  const std::string token = store_->List({}, 2, "")->next_page_token;
  ASSERT_TRUE(store_->Delete("job2").ok());
  EXPECT_THAT(Ids(store_->List({}, 2, token)->jobs), ElementsAre("job1", "job0"));
}

TEST_F(SqliteStoreTest, PageTokensOfAnOwnerTellNothingOfOthers) {
  const JobFilter anna{"anna", {}};
  std::vector<std::string> tokens;
  for (const int others : {0, 1, 100}) {
    const auto store = SqliteStore::Open(":memory:");
    const auto add = [&](const std::string& id, const std::string& owner) {
      Job job = NewJob(id);
      job.owner = owner;
      ASSERT_TRUE((*store)->Create(job, "", Reuse::kNothing, absl::OkStatus()).ok());
    };
    for (int i = 0; i < others; ++i) add(absl::StrCat("other", i), "boris");
    add("a", "anna");
    add("b", "anna");
    tokens.push_back((*store)->List(anna, 1, "")->next_page_token);
  }
  EXPECT_THAT(tokens, ElementsAre(tokens[0], tokens[0], tokens[0]));
}

TEST_F(SqliteStoreTest, HasNoNextPageWhenThisOneIsJustFull) {
  Add("a");
  Add("b");
  EXPECT_EQ(store_->List({}, 2, "")->next_page_token, "");
}

TEST_F(SqliteStoreTest, ListsOnlyTheStatesAskedFor) {
  for (const char* id : {"a", "b", "c"}) Add(id);
  ASSERT_TRUE(store_->MarkStarted("b", kNow).ok());
  ASSERT_TRUE(store_->MarkEnded("c", JobState::kCancelled, {}, "", kNow).ok());
  const JobFilter filter{std::nullopt, {JobState::kRunning, JobState::kCancelled}};
  const auto page = store_->List(filter, 1, "");
  EXPECT_THAT(Ids(page->jobs), ElementsAre("c"));
  EXPECT_THAT(Ids(store_->List(filter, 1, page->next_page_token)->jobs), ElementsAre("b"));
}

TEST_F(SqliteStoreTest, RefusesTokensThatAreNotItsOwn) {
  Add("a");
  Add("b");
  EXPECT_TRUE(absl::IsInvalidArgument(store_->List({}, 1, "nonsense").status()));
  const std::string token = store_->List({}, 1, "")->next_page_token;
  const JobFilter other{std::nullopt, {JobState::kRunning}};
  EXPECT_TRUE(absl::IsInvalidArgument(store_->List(other, 1, token).status()));
}

TEST_F(SqliteStoreTest, FindsWhatHasNotEndedTheOldestFirst) {
  for (const char* id : {"a", "b", "c"}) Add(id);
  ASSERT_TRUE(store_->MarkStarted("c", kNow).ok());
  ASSERT_TRUE(store_->MarkEnded("b", JobState::kSucceeded, {}, "r", kNow).ok());
  Open();
  EXPECT_THAT(Ids(*store_->Unfinished()), ElementsAre("a", "c"));
}

TEST_F(SqliteStoreTest, StartsAJobOnce) {
  Add("a");
  ASSERT_TRUE(store_->MarkStarted("a", kNow).ok());
  ASSERT_TRUE(store_->MarkStarted("a", kNow + absl::Seconds(1)).ok());
  EXPECT_EQ(store_->Get("a")->state, JobState::kRunning);
  EXPECT_EQ(store_->Get("a")->started, kNow);
}

TEST_F(SqliteStoreTest, EndsAJobOnce) {
  Add("a");
  const absl::Status error = absl::OutOfRangeError("orbit lost");
  ASSERT_TRUE(store_->MarkEnded("a", JobState::kFailed, error, "", kNow).ok());
  EXPECT_TRUE(
      absl::IsFailedPrecondition(store_->MarkEnded("a", JobState::kSucceeded, {}, "result", kNow)));
  Open();
  EXPECT_EQ(store_->Get("a")->state, JobState::kFailed);
  EXPECT_EQ(store_->Get("a")->error, error);
  EXPECT_EQ(store_->Get("a")->result, "");
  EXPECT_EQ(store_->Get("a")->ended, kNow);
}

TEST_F(SqliteStoreTest, KeepsWhatWasCommitted) {
  Add("a");
  ASSERT_TRUE(store_->Commit("a", FirstCommit()).ok());
  Open();
  const auto waiting = store_->LoadProgress("a");
  ASSERT_TRUE(waiting.ok()) << waiting.status();
  ASSERT_EQ(waiting->pending.size(), 1U);
  EXPECT_EQ(waiting->pending[0].payload, "waits");
  EXPECT_EQ(waiting->fold_next, UnitId{});

  ASSERT_TRUE(store_->Commit("a", SecondCommit()).ok());
  Open();
  const auto folded = store_->LoadProgress("a");
  EXPECT_THAT(folded->pending, IsEmpty());
  EXPECT_EQ(folded->fold_state, "folded");
  EXPECT_EQ(folded->fold_next, (UnitId{1, 1}));
  ASSERT_EQ(folded->chains.size(), 2U);
  EXPECT_EQ(folded->chains[0].checkpoint, "zero");
  EXPECT_TRUE(folded->chains[0].ended);
  EXPECT_EQ(folded->chains[1].checkpoint, "one");
  EXPECT_FALSE(folded->chains[1].ended);
  EXPECT_EQ(store_->Get("a")->work_done, 2);
  EXPECT_EQ(store_->Get("a")->last_sequence, 3);
}

TEST_F(SqliteStoreTest, NumbersRecordsWithoutGaps) {
  Add("a");
  Add("b");
  ASSERT_TRUE(store_->Commit("a", SecondCommit()).ok());
  ASSERT_TRUE(store_->Commit("b", SecondCommit()).ok());
  UnitCommit more;
  more.records = {"more"};
  ASSERT_TRUE(store_->Commit("a", more).ok());
  EXPECT_THAT(Bytes(*store_->Records("a", 0, kPlenty)),
              ElementsAre("1:x", "2:yy", "3:zzz", "4:more"));
}

TEST_F(SqliteStoreTest, GivesRecordsAfterANumberAsManyAsFit) {
  Add("a");
  ASSERT_TRUE(store_->Commit("a", SecondCommit()).ok());
  EXPECT_THAT(Bytes(*store_->Records("a", 1, kPlenty)), ElementsAre("2:yy", "3:zzz"));
  EXPECT_THAT(Bytes(*store_->Records("a", 0, 3)), ElementsAre("1:x", "2:yy"));
  EXPECT_THAT(Bytes(*store_->Records("a", 2, 1)), ElementsAre("3:zzz")) << "one at least";
  EXPECT_THAT(*store_->Records("a", 3, kPlenty), IsEmpty());
}

TEST_F(SqliteStoreTest, KnowsNoRecordBeforeTheFirst) {
  Add("a");
  const absl::Status status = store_->Records("a", -1, kPlenty).status();
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_THAT(std::string(status.message()), ::testing::StartsWith("after_sequence: -1"));
}

TEST_F(SqliteStoreTest, CommitsAllOrNothing) {
  Add("a");
  ASSERT_TRUE(store_->Commit("a", FirstCommit()).ok());
  UnitCommit twice =
      FirstCommit();  // the payload is there already, so that this must fail half way
  twice.position.checkpoint = "changed";
  twice.records = {"record"};
  EXPECT_FALSE(store_->Commit("a", twice).ok());
  EXPECT_EQ(store_->LoadProgress("a")->chains[0].checkpoint, "one");
  EXPECT_THAT(*store_->Records("a", 0, kPlenty), IsEmpty());
  EXPECT_TRUE(store_->Commit("a", SecondCommit()).ok()) << "the store goes on";
}

TEST_F(SqliteStoreTest, TakesNothingForAJobThatEnded) {
  Add("a");
  ASSERT_TRUE(store_->Commit("a", FirstCommit()).ok());
  ASSERT_TRUE(store_->MarkEnded("a", JobState::kCancelled, {}, "", kNow).ok());
  EXPECT_TRUE(absl::IsFailedPrecondition(store_->Commit("a", SecondCommit())));
  EXPECT_THAT(*store_->Records("a", 0, kPlenty), IsEmpty());
}

TEST_F(SqliteStoreTest, KeepsOnlyTheRecordsOfAJobThatEnded) {
  Add("a");
  ASSERT_TRUE(store_->Commit("a", FirstCommit()).ok());
  ASSERT_TRUE(store_->Commit("a", SecondCommit()).ok());
  ASSERT_TRUE(store_->MarkEnded("a", JobState::kSucceeded, {}, "result", kNow).ok());
  const auto progress = store_->LoadProgress("a");
  EXPECT_THAT(progress->chains, IsEmpty());
  EXPECT_EQ(progress->fold_state, "");
  EXPECT_EQ(store_->Records("a", 0, kPlenty)->size(), 3U);
  EXPECT_EQ(store_->Get("a")->result, "result");
}

TEST_F(SqliteStoreTest, DeletesAJobWithAllThatIsItsOwn) {
  Add("a");
  ASSERT_TRUE(store_->Commit("a", FirstCommit()).ok());
  ASSERT_TRUE(store_->Commit("a", SecondCommit()).ok());
  ASSERT_TRUE(store_->Delete("a").ok());
  EXPECT_TRUE(absl::IsNotFound(store_->Get("a").status()));
  Add("a");  // of the same name, and of none of the other's data
  EXPECT_THAT(*store_->Records("a", 0, kPlenty), IsEmpty());
  EXPECT_THAT(store_->LoadProgress("a")->chains, IsEmpty());
}

TEST(SqliteStoreInMemory, Works) {
  const auto store = SqliteStore::Open(":memory:");
  ASSERT_TRUE(store.ok()) << store.status();
  ASSERT_TRUE((*store)->Create(NewJob("a"), "", Reuse::kNothing, absl::OkStatus()).ok());
  ASSERT_TRUE((*store)->Commit("a", SecondCommit()).ok());
  EXPECT_EQ((*store)->Records("a", 0, kPlenty)->size(), 3U);
}

}  // namespace
}  // namespace celt::jobs
