// The process dies at every point at which it speaks to the database, and what comes out in the end
// is what would have come out anyway.

#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <memory>
#include <string>

#include "gtest/gtest.h"
#include "jobs/scheduler_testing.h"
#include "jobs/toy_plan.h"
#include "temporary_directory.h"

namespace celt::jobs {
namespace {

/// How many statements may still begin or end before the process is killed; negative: any number.
std::atomic<int> statements_left = -1;

int CountStatement(unsigned /*event*/, void*, void*, void*) {
  if (statements_left > 0 && --statements_left == 0) kill(getpid(), SIGKILL);
  return 0;
}

/// Called by SQLite for each new connection.
int WatchConnection(sqlite3* connection, const char** /*error*/, const void* /*routines*/) {
  // The end of COMMIT is one of these: what is killed there has been committed.
  return sqlite3_trace_v2(connection, SQLITE_TRACE_STMT | SQLITE_TRACE_PROFILE, CountStatement,
                          nullptr);
}

const Toy kToy{.chains = 2, .steps = 3, .lengths = {{1, 2}}};
const char* const kRequest = "request";

/// A server's life: goes on with what there is, takes a request, and ends when it is done.
std::string Live(const std::string& path) {
  const auto store = SqliteStore::Open(path);
  if (!store.ok()) return "";
  SchedulerOptions options;
  options.workers = 2;
  Scheduler scheduler(**store, ToyFactory({{"toy", kToy}}), options);
  if (!scheduler.Start().ok()) return "";
  const std::string id = Submit(scheduler, "toy", kRequest);
  AwaitEnd(scheduler, **store, id);
  return id;
}

/// Whether a life that ends at that statement reached its own end before.
bool LiveUntil(const std::string& path, int statement) {
  const pid_t child = fork();
  if (child == 0) {
    statements_left = statement;
    _exit(Live(path).empty() ? 1 : 0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  const bool killed = WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  EXPECT_TRUE(killed || (WIFEXITED(status) && WEXITSTATUS(status) == 0)) << status;
  return !killed;
}

class CrashTest : public ::testing::Test {
 protected:
  CrashTest() {
    // The type that SQLite's own documentation casts to.
    sqlite3_auto_extension(reinterpret_cast<void (*)()>(WatchConnection));
  }
  ~CrashTest() override {
    sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(WatchConnection));
  }

  static Answer Expected() {
    const auto store = MemoryStore();
    Scheduler scheduler(*store, ToyFactory({{"toy", kToy}}), {});
    EXPECT_TRUE(scheduler.Start().ok());
    return AwaitEnd(scheduler, *store, Submit(scheduler, "toy"));
  }
  static void ExpectOneJobWith(const std::string& path, const Answer& expected) {
    const auto store = SqliteStore::Open(path);
    ASSERT_TRUE(store.ok()) << store.status();
    const auto jobs = (*store)->List({}, 10, "");
    ASSERT_EQ(jobs->jobs.size(), 1U);
    EXPECT_EQ(AnswerOf(**store, jobs->jobs[0].id), expected);
  }
};

TEST_F(CrashTest, AtAnyStatementLosesNothingAndDoesNothingTwice) {
  const Answer expected = Expected();
  bool reached_the_end = false;
  int statement = 0;
  while (!reached_the_end) {
    const TemporaryDirectory temporary;
    const std::string path = temporary / "jobs.sqlite";
    reached_the_end = LiveUntil(path, ++statement);
    EXPECT_TRUE(LiveUntil(path, -1));
    ExpectOneJobWith(path, expected);
    ASSERT_FALSE(HasFailure()) << "killed at statement " << statement;
  }
  EXPECT_GT(statement, 100) << "the lives were long enough to be cut anywhere";
}

TEST_F(CrashTest, AgainAndAgainStillEnds) {
  const Answer expected = Expected();
  // Longer than the opening of a store and a commit, so that each life gets somewhere.
  for (const int statements : {60, 67, 71, 83}) {
    const TemporaryDirectory temporary;
    const std::string path = temporary / "jobs.sqlite";
    int lives = 1;
    while (!LiveUntil(path, statements)) ++lives;
    EXPECT_GT(lives, 2);
    ExpectOneJobWith(path, expected);
  }
}

}  // namespace
}  // namespace celt::jobs
