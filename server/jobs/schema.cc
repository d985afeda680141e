#include "server/jobs/schema.h"

#include <array>
#include <cstdint>
#include <string>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

/// "CELT", in the field of SQLite's header that tells whose file it is.
constexpr std::int64_t kApplicationId = 0x43454c54;

/// Each entry leads from the schema of its index to the next. Never change one that was released:
/// append.
constexpr std::array<const char*, 5> kMigrations = {
    R"sql(
  CREATE TABLE jobs (
    serial INTEGER PRIMARY KEY AUTOINCREMENT,  -- the order of creation
    id TEXT NOT NULL UNIQUE,
    request_id TEXT UNIQUE,
    specification BLOB NOT NULL,
    state INTEGER NOT NULL,
    work_done REAL NOT NULL,
    work_total REAL NOT NULL,
    work_unit TEXT NOT NULL,
    last_sequence INTEGER NOT NULL,
    error_code INTEGER NOT NULL,
    error_message TEXT NOT NULL,
    result BLOB NOT NULL,
    created INTEGER NOT NULL,  -- times in nanoseconds since 1970
    started INTEGER,
    ended INTEGER
  );
  CREATE INDEX jobs_by_state ON jobs (state, serial);
  CREATE TABLE folds (
    job INTEGER PRIMARY KEY REFERENCES jobs ON DELETE CASCADE,
    state BLOB NOT NULL,
    next_step INTEGER NOT NULL,
    next_chain INTEGER NOT NULL
  );
  CREATE TABLE chains (
    job INTEGER NOT NULL REFERENCES jobs ON DELETE CASCADE,
    chain INTEGER NOT NULL,
    next_step INTEGER NOT NULL,
    ended INTEGER NOT NULL,
    checkpoint BLOB NOT NULL,
    PRIMARY KEY (job, chain)
  ) WITHOUT ROWID;
  CREATE TABLE payloads (
    job INTEGER NOT NULL REFERENCES jobs ON DELETE CASCADE,
    step INTEGER NOT NULL,
    chain INTEGER NOT NULL,
    payload BLOB NOT NULL,
    PRIMARY KEY (job, step, chain)
  ) WITHOUT ROWID;
  CREATE TABLE records (
    job INTEGER NOT NULL REFERENCES jobs ON DELETE CASCADE,
    sequence INTEGER NOT NULL,
    bytes BLOB NOT NULL,
    PRIMARY KEY (job, sequence)
  ) WITHOUT ROWID;
)sql",
    // Owners, engine versions, requests of their own
    R"sql(
  CREATE TABLE new_jobs (
    serial INTEGER PRIMARY KEY AUTOINCREMENT,
    id TEXT NOT NULL UNIQUE,
    owner TEXT NOT NULL,
    specification BLOB NOT NULL,
    engine_version INTEGER NOT NULL,
    state INTEGER NOT NULL,
    work_done REAL NOT NULL,
    work_total REAL NOT NULL,
    work_unit TEXT NOT NULL,
    last_sequence INTEGER NOT NULL,
    error_code INTEGER NOT NULL,
    error_message TEXT NOT NULL,
    result BLOB NOT NULL,
    created INTEGER NOT NULL,
    started INTEGER,
    ended INTEGER
  );
  INSERT INTO new_jobs SELECT serial, id, '', specification, 0, state, work_done, work_total,
    work_unit, last_sequence, error_code, error_message, result, created, started, ended FROM jobs;
  CREATE TABLE requests (
    owner TEXT NOT NULL,
    request_id TEXT NOT NULL,
    job INTEGER NOT NULL REFERENCES jobs ON DELETE CASCADE,
    reuse INTEGER NOT NULL,
    PRIMARY KEY (owner, request_id)
  ) WITHOUT ROWID;
  CREATE INDEX requests_by_job ON requests (job);
  INSERT INTO requests SELECT '', request_id, serial, 1 FROM jobs WHERE request_id IS NOT NULL;
  DROP TABLE jobs;
  ALTER TABLE new_jobs RENAME TO jobs;
  CREATE INDEX jobs_by_state ON jobs (state, serial);
  CREATE INDEX jobs_by_specification ON jobs (owner, specification);
)sql",
    R"sql(
  ALTER TABLE jobs ADD COLUMN unit_seconds REAL NOT NULL DEFAULT 0;
)sql",
    R"sql(
  ALTER TABLE jobs ADD COLUMN dropped INTEGER NOT NULL DEFAULT 0;  -- records up to this one
  CREATE INDEX jobs_by_end ON jobs (ended);
)sql",
    R"sql(
  CREATE INDEX jobs_by_creation ON jobs (created);
)sql"};
constexpr std::int64_t kSchema = kMigrations.size();

absl::Status Refuse(const Database& database, std::string_view why) {
  return absl::FailedPreconditionError(
      absl::StrCat("job store ", database.path(), ": ", std::string(why)));
}

/// A file of ours, or one in which nothing is.
absl::Status CheckOwner(Database& database) {
  CELT_ASSIGN_OR_RETURN(const std::int64_t owner, database.QueryInt("PRAGMA application_id", {}));
  if (owner == kApplicationId) return absl::OkStatus();
  CELT_ASSIGN_OR_RETURN(const std::int64_t tables,
                        database.QueryInt("SELECT count(*) FROM sqlite_schema", {}));
  if (owner == 0 && tables == 0) return absl::OkStatus();
  return Refuse(database, "the file is a database of another program");
}

absl::Status CheckIntegrity(Database& database) {
  std::string verdict;
  CELT_RETURN_IF_ERROR(database.Query("PRAGMA quick_check(1)", {}, [&](const Row& row) {
    verdict = row.Bytes(0);
    return false;
  }));
  if (verdict == "ok") return absl::OkStatus();
  return absl::DataLossError(
      absl::StrCat("job store ", database.path(), ": the file is corrupt: ", verdict));
}

absl::Status Migrate(Database& database, std::int64_t from) {
  Transaction transaction(database);
  CELT_RETURN_IF_ERROR(transaction.Begin());
  for (std::int64_t schema = from; schema < kSchema; ++schema) {
    CELT_RETURN_IF_ERROR(database.Execute(kMigrations[schema]));
  }
  CELT_RETURN_IF_ERROR(database.Execute(absl::StrCat("PRAGMA application_id = ", kApplicationId,
                                                     "; PRAGMA user_version = ", kSchema)));
  return transaction.Commit();
}

}  // namespace

absl::Status PrepareSchema(Database& database, Synchronous synchronous) {
  CELT_RETURN_IF_ERROR(CheckOwner(database));
  CELT_ASSIGN_OR_RETURN(const std::int64_t schema, database.QueryInt("PRAGMA user_version", {}));
  if (schema > kSchema) {
    return Refuse(database, absl::StrCat("written by a newer celt (schema ", schema,
                                         ", this program knows ", kSchema, ")"));
  }
  CELT_RETURN_IF_ERROR(CheckIntegrity(database));
  // With WAL, a commit survives the death of the process, and the file a power cut, in either way.
  CELT_RETURN_IF_ERROR(database.Execute(absl::StrCat(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = ", static_cast<int>(synchronous))));
  if (schema < kSchema) CELT_RETURN_IF_ERROR(Migrate(database, schema));
  // After the migrations: one that replaces a table would drop all that refers to it.
  return database.Execute("PRAGMA foreign_keys = ON;");
}

}  // namespace celt::jobs
