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

TEST(Schema, OfANewFileIsMadeOnceAndFoundAgain) {
  const TemporaryDirectory temporary;
  for (int i = 0; i < 2; ++i) {
    const auto store = SqliteStore::Open(temporary / "jobs.sqlite");
    EXPECT_TRUE(store.ok()) << store.status();
  }
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
    ASSERT_TRUE((*store)->Create(job).ok());
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
