#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

#include "absl/functional/function_ref.h"
#include "absl/status/status.h"
#include "absl/status/statusor.h"

struct sqlite3;
struct sqlite3_stmt;

namespace celt::jobs {

/// Bytes, where text is not meant.
struct Blob {
  std::string_view bytes;
};

/// A value to bind; nullptr is SQL's NULL.
using Value = std::variant<std::nullptr_t, std::int64_t, double, std::string_view, Blob>;

/// A row of an answer; valid during the callback that it is given to.
class Row {
 public:
  explicit Row(sqlite3_stmt* statement) : statement_(statement) {}
  std::int64_t Int(int column) const;
  double Real(int column) const;
  std::string Bytes(int column) const;  ///< of text or blob; empty for NULL
  bool IsNull(int column) const;

 private:
  sqlite3_stmt* statement_;
};

/// Called for each row; false: no more rows, please.
using EachRow = absl::FunctionRef<bool(const Row& row)>;

/// A connection to an SQLite database that keeps its statements prepared. One thread at a time.
/// Errors: RESOURCE_EXHAUSTED for a full disk, DATA_LOSS for a corrupt or foreign file,
/// ALREADY_EXISTS for a broken uniqueness, UNAVAILABLE when another process holds the file,
/// PERMISSION_DENIED, else INTERNAL; all name the file.
class Database {
 public:
  /// Opens or creates; ":memory:" lives and dies with the connection.
  static absl::StatusOr<std::unique_ptr<Database>> Open(const std::string& path);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  const std::string& path() const { return path_; }

  /// Runs any number of statements without values; for schemas and pragmas.
  absl::Status Execute(const std::string& script);
  /// Runs one statement, which stays prepared for the next time.
  absl::Status Run(std::string_view sql, std::initializer_list<Value> values);
  absl::Status Query(std::string_view sql, std::initializer_list<Value> values, EachRow each);
  /// The first column of the first row.
  absl::StatusOr<std::int64_t> QueryInt(std::string_view sql, std::initializer_list<Value> values);

  /// Rows that the last Run changed.
  std::int64_t Changes() const;
  std::int64_t LastRowId() const;

 private:
  Database(std::string path, sqlite3* connection);
  absl::StatusOr<sqlite3_stmt*> Prepared(std::string_view sql);
  absl::Status Error(int code) const;

  std::string path_;
  sqlite3* connection_;
  std::map<std::string, sqlite3_stmt*, std::less<>> statements_;
};

/// Several statements as one: rolled back unless committed.
class Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) {}
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  absl::Status Begin();
  absl::Status Commit();

 private:
  Database& database_;
  bool open_ = false;
};

}  // namespace celt::jobs
