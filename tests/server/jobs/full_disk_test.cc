// A store that can't grow: SQLite's own limit gives the error that a full disk gives.

#include <sqlite3.h>

#include <atomic>
#include <string>

#include "absl/strings/str_cat.h"
#include "gtest/gtest.h"
#include "jobs/store_testing.h"

namespace celt::jobs {
namespace {

std::atomic<sqlite3*> last_connection = nullptr;

int Remember(sqlite3* connection, const char** /*error*/, const void* /*routines*/) {
  last_connection = connection;
  return SQLITE_OK;
}

class FullDiskTest : public SqliteStoreTest {
 protected:
  FullDiskTest() {
    // The type that SQLite's own documentation casts to.
    sqlite3_auto_extension(reinterpret_cast<void (*)()>(Remember));
    Open();
  }
  ~FullDiskTest() override {
    sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(Remember));
  }

  /// Pages beyond those in use; the same connection is used under the store's mutex elsewhere, so
  /// that nothing else may be under way.
  static void LeaveRoomFor(int pages) {
    const std::string pragma = absl::StrCat("PRAGMA max_page_count = ", pages);
    EXPECT_EQ(sqlite3_exec(last_connection, pragma.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  }
};

constexpr int kNone = 1;  // SQLite takes it for "no more than there are"
constexpr int kPlentyOfPages = 1 << 20;

TEST_F(FullDiskTest, IsSaidAndLeavesTheDataAsTheyWere) {
  Add("a");
  ASSERT_TRUE(store_->Commit("a", FirstCommit()).ok());
  LeaveRoomFor(kNone);
  UnitCommit large = SecondCommit();
  large.records = {std::string(100'000, 'r')};
  const absl::Status full = store_->Commit("a", large);
  EXPECT_TRUE(absl::IsResourceExhausted(full)) << full;
  EXPECT_EQ(store_->Get("a")->work_done, 1);
  EXPECT_EQ(store_->Get("a")->last_sequence, 0);
  LeaveRoomFor(kPlentyOfPages);
  EXPECT_TRUE(store_->Commit("a", large).ok()) << "and it goes on where there is room again";
  EXPECT_EQ(store_->Get("a")->last_sequence, 1);
}

TEST_F(FullDiskTest, RefusesANewJob) {
  LeaveRoomFor(kNone);
  Job job = NewJob("a");
  job.specification = std::string(100'000, 's');
  const absl::Status full = store_->Create(job, "", Reuse::kNothing, absl::OkStatus()).status();
  EXPECT_TRUE(absl::IsResourceExhausted(full)) << full;
  EXPECT_TRUE(absl::IsNotFound(store_->Get("a").status()));
}

}  // namespace
}  // namespace celt::jobs
