#include "server/jobs/progress_rows.h"

#include <utility>

#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

absl::Status WriteChain(Database& database, std::int64_t job, const ChainPosition& position) {
  return database.Run(
      "INSERT OR REPLACE INTO chains (job, chain, next_step, ended, checkpoint) "
      "VALUES (?, ?, ?, ?, ?)",
      {job, position.chain, position.next_step, std::int64_t{position.ended},
       Blob{position.checkpoint}});
}

/// A fold that has not moved keeps its row.
absl::Status WriteFold(Database& database, std::int64_t job, const UnitCommit& commit) {
  if (!commit.fold_state) return absl::OkStatus();
  return database.Run(
      "INSERT OR REPLACE INTO folds (job, state, next_step, next_chain) VALUES (?, ?, ?, ?)",
      {job, Blob{*commit.fold_state}, commit.fold_next.step, commit.fold_next.chain});
}

absl::Status ReadFold(Database& database, std::int64_t job, Progress& progress) {
  return database.Query("SELECT state, next_step, next_chain FROM folds WHERE job = ?", {job},
                        [&](const Row& row) {
                          progress.fold_state = row.Bytes(0);
                          progress.fold_next = UnitId{row.Int(1), row.Int(2)};
                          return false;
                        });
}

absl::Status ReadChains(Database& database, std::int64_t job, Progress& progress) {
  return database.Query(
      "SELECT chain, next_step, ended, checkpoint FROM chains WHERE job = ? ORDER BY chain", {job},
      [&](const Row& row) {
        progress.chains.push_back({row.Int(0), row.Int(1), row.Bytes(3), row.Int(2) != 0});
        return true;
      });
}

absl::Status ReadPayloads(Database& database, std::int64_t job, Progress& progress) {
  return database.Query(
      "SELECT step, chain, payload FROM payloads WHERE job = ? ORDER BY step, chain", {job},
      [&](const Row& row) {
        progress.pending.push_back({UnitId{row.Int(0), row.Int(1)}, row.Bytes(2)});
        return true;
      });
}

}  // namespace

absl::Status WriteProgress(Database& database, std::int64_t job, const UnitCommit& commit) {
  CELT_RETURN_IF_ERROR(WriteChain(database, job, commit.position));
  for (const PendingPayload& pending : commit.added) {
    CELT_RETURN_IF_ERROR(
        database.Run("INSERT INTO payloads (job, step, chain, payload) VALUES (?, ?, ?, ?)",
                     {job, pending.unit.step, pending.unit.chain, Blob{pending.payload}}));
  }
  for (const UnitId& unit : commit.collected) {
    CELT_RETURN_IF_ERROR(
        database.Run("DELETE FROM payloads WHERE job = ? AND step = ? AND chain = ?",
                     {job, unit.step, unit.chain}));
  }
  return WriteFold(database, job, commit);
}

absl::StatusOr<Progress> ReadProgress(Database& database, std::int64_t job) {
  Progress progress;
  CELT_RETURN_IF_ERROR(ReadFold(database, job, progress));
  CELT_RETURN_IF_ERROR(ReadChains(database, job, progress));
  CELT_RETURN_IF_ERROR(ReadPayloads(database, job, progress));
  return progress;
}

absl::Status DeleteProgress(Database& database, std::int64_t job) {
  CELT_RETURN_IF_ERROR(database.Run("DELETE FROM folds WHERE job = ?", {job}));
  CELT_RETURN_IF_ERROR(database.Run("DELETE FROM chains WHERE job = ?", {job}));
  return database.Run("DELETE FROM payloads WHERE job = ?", {job});
}

absl::Status AppendRecords(Database& database, std::int64_t job, std::int64_t last_sequence,
                           const std::vector<std::string>& records) {
  for (const std::string& bytes : records) {
    CELT_RETURN_IF_ERROR(database.Run("INSERT INTO records (job, sequence, bytes) VALUES (?, ?, ?)",
                                      {job, ++last_sequence, Blob{bytes}}));
  }
  return absl::OkStatus();
}

absl::StatusOr<std::vector<StoredRecord>> ReadRecords(Database& database, std::int64_t job,
                                                      std::int64_t after, std::size_t max_bytes) {
  std::vector<StoredRecord> records;
  std::size_t bytes = 0;
  CELT_RETURN_IF_ERROR(database.Query(
      "SELECT sequence, bytes FROM records WHERE job = ? AND sequence > ? ORDER BY sequence",
      {job, after}, [&](const Row& row) {
        StoredRecord record{row.Int(0), row.Bytes(1)};
        bytes += record.bytes.size();
        if (bytes > max_bytes && !records.empty()) return false;
        records.push_back(std::move(record));
        return true;
      }));
  return records;
}

}  // namespace celt::jobs
