#include "server/jobs/schema.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

#include "absl/time/clock.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "server/jobs/sqlite_store.h"
#include "temporary_directory.h"

namespace celt::jobs {
namespace {

using ::testing::HasSubstr;

std::string ReadFile(const std::string& path) {
  std::ostringstream contents;
  contents << std::ifstream(path, std::ios::binary).rdbuf();
  return contents.str();
}

void Script(const std::string& path, const std::string& script) {
  const auto database = Database::Open(path);
  ASSERT_TRUE(database.ok()) << database.status();
  const absl::Status status = (*database)->Execute(script);
  ASSERT_TRUE(status.ok()) << status;
}

/// Expects that the file is refused with all this in the message, and not touched.
void ExpectRefused(const std::string& path, absl::StatusCode code, const std::string& why) {
  const std::string before = ReadFile(path);
  const auto store = SqliteStore::Open(path);
  EXPECT_EQ(store.status().code(), code) << store.status();
  EXPECT_THAT(std::string(store.status().message()), HasSubstr(path));
  EXPECT_THAT(std::string(store.status().message()), HasSubstr(why));
  EXPECT_EQ(ReadFile(path), before);
}

TEST(Schema, WaitsForTheDiskAsItIsTold) {
  const TemporaryDirectory temporary;
  for (const Synchronous synchronous :
       {Synchronous::kFull, Synchronous::kNormal, Synchronous::kFull}) {
    const auto store = SqliteStore::Open(temporary / "jobs.sqlite", synchronous);
    ASSERT_TRUE(store.ok()) << store.status();
    EXPECT_EQ((*store)->Stats()->synchronous, synchronous);
  }
}

TEST(Schema, OfANewFileIsMadeOnceAndFoundAgain) {
  const TemporaryDirectory temporary;
  for (int i = 0; i < 2; ++i) {
    const auto store = SqliteStore::Open(temporary / "jobs.sqlite");
    EXPECT_TRUE(store.ok()) << store.status();
  }
}

/// As the first version of this program left it, with a job that has a record.
constexpr const char* kFirstSchema = R"sql(
  CREATE TABLE jobs (serial INTEGER PRIMARY KEY AUTOINCREMENT, id TEXT NOT NULL UNIQUE,
    request_id TEXT UNIQUE, specification BLOB NOT NULL, state INTEGER NOT NULL,
    work_done REAL NOT NULL, work_total REAL NOT NULL, work_unit TEXT NOT NULL,
    last_sequence INTEGER NOT NULL, error_code INTEGER NOT NULL, error_message TEXT NOT NULL,
    result BLOB NOT NULL, created INTEGER NOT NULL, started INTEGER, ended INTEGER);
  CREATE INDEX jobs_by_state ON jobs (state, serial);
  CREATE TABLE folds (job INTEGER PRIMARY KEY REFERENCES jobs ON DELETE CASCADE,
    state BLOB NOT NULL, next_step INTEGER NOT NULL, next_chain INTEGER NOT NULL);
  CREATE TABLE chains (job INTEGER NOT NULL REFERENCES jobs ON DELETE CASCADE,
    chain INTEGER NOT NULL, next_step INTEGER NOT NULL, ended INTEGER NOT NULL,
    checkpoint BLOB NOT NULL, PRIMARY KEY (job, chain)) WITHOUT ROWID;
  CREATE TABLE payloads (job INTEGER NOT NULL REFERENCES jobs ON DELETE CASCADE,
    step INTEGER NOT NULL, chain INTEGER NOT NULL, payload BLOB NOT NULL,
    PRIMARY KEY (job, step, chain)) WITHOUT ROWID;
  CREATE TABLE records (job INTEGER NOT NULL REFERENCES jobs ON DELETE CASCADE,
    sequence INTEGER NOT NULL, bytes BLOB NOT NULL, PRIMARY KEY (job, sequence)) WITHOUT ROWID;
  INSERT INTO jobs VALUES (7, 'old', 'request', x'73706563', 3, 1, 2, 'units', 1, 0, '',
    x'726573756c74', 1000000000, NULL, 2000000000);
  INSERT INTO records VALUES (7, 1, x'61');
  PRAGMA application_id = 0x43454c54;
  PRAGMA user_version = 1;
)sql";

TEST(Schema, OfTheFirstVersionIsMigratedWithAllThatIsInIt) {
  const TemporaryDirectory temporary;
  Script(temporary / "jobs.sqlite", kFirstSchema);
  const auto store = SqliteStore::Open(temporary / "jobs.sqlite");
  ASSERT_TRUE(store.ok()) << store.status();
  const auto job = (*store)->Get("old");
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_EQ(job->specification, "spec");
  EXPECT_EQ(job->result, "result");
  EXPECT_EQ(job->owner, "");
  EXPECT_EQ(job->created, absl::FromUnixSeconds(1));
  EXPECT_EQ((*store)->Records("old", 0, 100)->size(), 1U);
  Job same = *job;
  same.id = "new";
  EXPECT_EQ((*store)->Create(same, "request", Reuse::kAnswers, absl::OkStatus())->id, "old");
  same.engine_version = 1;
  EXPECT_EQ((*store)->Create(same, "", Reuse::kAnswers, absl::OkStatus())->id, "new")
      << "of no known engine";
  EXPECT_TRUE((*store)->Delete("old").ok());
}

TEST(Schema, RefusesADatabaseOfAnotherProgram) {
  const TemporaryDirectory temporary;
  Script(temporary / "other.sqlite", "CREATE TABLE bookmarks (url TEXT)");
  ExpectRefused(temporary / "other.sqlite", absl::StatusCode::kFailedPrecondition,
                "another program");
}

TEST(Schema, RefusesANewerOneAndNamesBoth) {
  const TemporaryDirectory temporary;
  ASSERT_TRUE(SqliteStore::Open(temporary / "jobs.sqlite").ok());
  Script(temporary / "jobs.sqlite", "PRAGMA user_version = 999");
  ExpectRefused(temporary / "jobs.sqlite", absl::StatusCode::kFailedPrecondition,
                "newer celt (schema 999");
}

TEST(Schema, RefusesAFileThatIsNoDatabase) {
  const TemporaryDirectory temporary;
  std::ofstream(temporary / "jobs.sqlite") << std::string(5000, 'x');
  ExpectRefused(temporary / "jobs.sqlite", absl::StatusCode::kDataLoss, "not a database");
}

TEST(Schema, RefusesACorruptFile) {
  const TemporaryDirectory temporary;
  const std::string path = temporary / "jobs.sqlite";
  {
    const auto store = SqliteStore::Open(path);
    ASSERT_TRUE(store.ok()) << store.status();
    Job job;
    job.id = "a";
    job.specification = std::string(100'000, 's');
    job.created = absl::Now();
    ASSERT_TRUE((*store)->Create(job, "", Reuse::kNothing, absl::OkStatus()).ok());
  }
  // All but the first page, which says whose file it is and what tables it has.
  constexpr std::streamoff kPage = 4096;
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(kPage);
  file << std::string(std::filesystem::file_size(path) - kPage, '\x5a');
  file.close();
  ExpectRefused(path, absl::StatusCode::kDataLoss, "");
}

TEST(Schema, NamesAFileThatCanNotBeOpened) {
  const TemporaryDirectory temporary;
  const auto store = SqliteStore::Open(temporary / "missing/jobs.sqlite");
  EXPECT_EQ(store.status().code(), absl::StatusCode::kPermissionDenied);
  EXPECT_THAT(std::string(store.status().message()), HasSubstr("missing/jobs.sqlite"));
}

}  // namespace
}  // namespace celt::jobs
