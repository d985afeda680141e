#include "server/jobs/database.h"

#include <sqlite3.h>

#include <utility>

#include "absl/strings/str_cat.h"
#include "server/jobs/status_macros.h"

namespace celt::jobs {
namespace {

constexpr int kBusyMilliseconds = 5000;

absl::StatusCode ToCode(int code) {
  switch (code & 0xff) {
    case SQLITE_FULL:
      return absl::StatusCode::kResourceExhausted;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return absl::StatusCode::kDataLoss;
    case SQLITE_CONSTRAINT:
      return absl::StatusCode::kAlreadyExists;
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return absl::StatusCode::kUnavailable;
    case SQLITE_CANTOPEN:
    case SQLITE_READONLY:
    case SQLITE_PERM:
      return absl::StatusCode::kPermissionDenied;
    default:
      return absl::StatusCode::kInternal;
  }
}

/// SQLite takes lengths as int here; a value never comes near that, its own limit of 10⁹ bytes is
/// lower.
int Length(std::string_view bytes) { return static_cast<int>(bytes.size()); }

/// Binds without a copy: values outlive the statement's run. An empty view must not be bound as
/// NULL.
struct Binder {
  sqlite3_stmt* statement;
  int index;
  int operator()(std::nullptr_t) const { return sqlite3_bind_null(statement, index); }
  int operator()(std::int64_t value) const { return sqlite3_bind_int64(statement, index, value); }
  int operator()(double value) const { return sqlite3_bind_double(statement, index, value); }
  int operator()(std::string_view value) const {
    return sqlite3_bind_text(statement, index, value.empty() ? "" : value.data(), Length(value),
                             nullptr);
  }
  int operator()(Blob value) const {
    const std::string_view bytes = value.bytes;
    return sqlite3_bind_blob(statement, index, bytes.empty() ? "" : bytes.data(), Length(bytes),
                             nullptr);
  }
};

/// Makes a statement ready for its next use, whatever becomes of this one.
class ResetAtExit {
 public:
  explicit ResetAtExit(sqlite3_stmt* statement) : statement_(statement) {}
  ~ResetAtExit() {
    sqlite3_reset(statement_);
    sqlite3_clear_bindings(statement_);
  }
  ResetAtExit(const ResetAtExit&) = delete;
  ResetAtExit& operator=(const ResetAtExit&) = delete;

 private:
  sqlite3_stmt* statement_;
};

}  // namespace

std::int64_t Row::Int(int column) const { return sqlite3_column_int64(statement_, column); }
double Row::Real(int column) const { return sqlite3_column_double(statement_, column); }
bool Row::IsNull(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}
std::string Row::Bytes(int column) const {
  const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement_, column));
  return bytes == nullptr ? std::string()
                          : std::string(bytes, sqlite3_column_bytes(statement_, column));
}

Database::Database(std::string path, sqlite3* connection)
    : path_(std::move(path)), connection_(connection) {}

absl::StatusOr<std::unique_ptr<Database>> Database::Open(const std::string& path) {
  sqlite3* connection = nullptr;
  constexpr int kFlags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  const int code = sqlite3_open_v2(path.c_str(), &connection, kFlags, nullptr);
  std::unique_ptr<Database> database(new Database(path, connection));
  if (code != SQLITE_OK) return database->Error(code);
  sqlite3_busy_timeout(connection, kBusyMilliseconds);
  return database;
}

Database::~Database() {
  for (const auto& [sql, statement] : statements_) sqlite3_finalize(statement);
  sqlite3_close(connection_);
}

absl::Status Database::Error(int code) const {
  const char* message = connection_ == nullptr ? sqlite3_errstr(code) : sqlite3_errmsg(connection_);
  return absl::Status(ToCode(code), absl::StrCat("job store ", path_, ": ", message));
}

absl::Status Database::Execute(const std::string& script) {
  const int code = sqlite3_exec(connection_, script.c_str(), nullptr, nullptr, nullptr);
  return code == SQLITE_OK ? absl::OkStatus() : Error(code);
}

absl::StatusOr<sqlite3_stmt*> Database::Prepared(std::string_view sql) {
  if (const auto found = statements_.find(sql); found != statements_.end()) return found->second;
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v3(connection_, sql.data(), Length(sql),
                                      SQLITE_PREPARE_PERSISTENT, &statement, nullptr);
  if (code != SQLITE_OK) return Error(code);
  statements_.emplace(sql, statement);
  return statement;
}

absl::Status Database::Query(std::string_view sql, std::initializer_list<Value> values,
                             EachRow each) {
  CELT_ASSIGN_OR_RETURN(sqlite3_stmt * statement, Prepared(sql));
  const ResetAtExit reset(statement);
  int index = 0;
  for (const Value& value : values) {
    const int code = std::visit(Binder{statement, ++index}, value);
    if (code != SQLITE_OK) return Error(code);
  }
  for (;;) {
    const int code = sqlite3_step(statement);
    if (code == SQLITE_DONE) return absl::OkStatus();
    if (code != SQLITE_ROW) return Error(code);
    if (!each(Row(statement))) return absl::OkStatus();
  }
}

absl::Status Database::Run(std::string_view sql, std::initializer_list<Value> values) {
  return Query(sql, values, [](const Row&) { return true; });
}

absl::StatusOr<std::int64_t> Database::QueryInt(std::string_view sql,
                                                std::initializer_list<Value> values) {
  std::int64_t result = 0;
  CELT_RETURN_IF_ERROR(Query(sql, values, [&](const Row& row) {
    result = row.Int(0);
    return false;
  }));
  return result;
}

std::int64_t Database::Changes() const { return sqlite3_changes64(connection_); }
std::int64_t Database::LastRowId() const { return sqlite3_last_insert_rowid(connection_); }

absl::Status Transaction::Begin() {
  absl::Status status = database_.Run("BEGIN IMMEDIATE", {});
  open_ = status.ok();
  return status;
}

absl::Status Transaction::Commit() {
  absl::Status status = database_.Run("COMMIT", {});
  open_ = open_ && !status.ok();
  return status;
}

Transaction::~Transaction() {
  // SQLite itself has rolled back after some errors; then there is nothing to roll back, and no
  // harm in saying so.
  if (open_) database_.Run("ROLLBACK", {}).IgnoreError();
}

}  // namespace celt::jobs
