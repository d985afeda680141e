#include "server/jobs/limits.h"

#include <memory>
#include <string>

#include "absl/strings/cord.h"
#include "absl/synchronization/notification.h"
#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/scheduler_testing.h"
#include "jobs/toy_plan.h"
#include "server/jobs/status_details.h"

namespace celt::jobs {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

absl::StatusOr<Job> SubmitAs(Scheduler& scheduler, const std::string& owner,
                             const std::string& specification = "toy") {
  return scheduler.Submit(
      {.specification = specification, .owner = owner, .request_id = {}, .fresh = true});
}

SchedulerOptions OneWorker(const JobLimits& limits) {
  SchedulerOptions options;
  options.workers = 1;
  options.limits = limits;
  return options;
}

/// No threads: what is submitted stays.
class FullQueueTest : public ::testing::Test {
 protected:
  static JobLimits Limits() {
    JobLimits limits;
    limits.unfinished = 3;
    limits.unfinished_per_owner = 2;
    return limits;
  }
  std::unique_ptr<SqliteStore> store_ = MemoryStore();
  Scheduler scheduler_{*store_, ToyFactory({{"toy", {}}, {"known", {}}}), OneWorker(Limits())};
};

TEST_F(FullQueueTest, RefusesAnOwnersNextJobAndTakesAnothers) {
  ASSERT_TRUE(SubmitAs(scheduler_, "anna").ok());
  const auto second = SubmitAs(scheduler_, "anna");
  ASSERT_TRUE(second.ok());
  const absl::Status refused = SubmitAs(scheduler_, "anna").status();
  EXPECT_TRUE(absl::IsResourceExhausted(refused)) << refused;
  EXPECT_TRUE(refused.GetPayload(kRetrySecondsPayload).has_value());
  EXPECT_TRUE(SubmitAs(scheduler_, "boris").ok());
  EXPECT_TRUE(absl::IsResourceExhausted(SubmitAs(scheduler_, "clara").status()));
  EXPECT_THAT(store_->List({}, 10, "")->jobs, SizeIs(3)) << "nothing is kept of what was refused";
  ASSERT_TRUE(scheduler_.Cancel(second->id).ok());
  EXPECT_TRUE(SubmitAs(scheduler_, "anna").ok()) << "an ended job makes room";
}

TEST_F(FullQueueTest, StillServesWhatIsKnown) {
  Job known;
  known.id = "known";
  known.owner = "anna";
  known.specification = "known";
  known.state = JobState::kSucceeded;
  ASSERT_TRUE(store_->Create(known, "", Reuse::kNothing, absl::OkStatus()).ok());
  for (int i = 0; i < 2; ++i) ASSERT_TRUE(SubmitAs(scheduler_, "anna").ok());
  const auto answered = scheduler_.Submit({.specification = "known", .owner = "anna"});
  ASSERT_TRUE(answered.ok()) << answered.status();
  EXPECT_EQ(answered->id, "known");
}

TEST(JobLimits, FailAJobThatComputesTooLongWhateverTheInterruptions) {
  // Every look at the clock is a second later: each unit takes one.
  absl::Time now = absl::UnixEpoch();
  JobLimits limits;
  limits.computing_time = absl::Seconds(2.5);
  SchedulerOptions options = OneWorker(limits);
  options.clock = [&now] { return now += absl::Seconds(1); };
  const auto store = MemoryStore();
  Scheduler scheduler(*store, ToyFactory({{"toy", {.chains = 1, .steps = 10}}}), options);
  ASSERT_TRUE(scheduler.Start().ok());
  const auto job = SubmitAs(scheduler, "");
  const Answer answer = AwaitEnd(scheduler, *store, job->id);
  EXPECT_EQ(answer.state, JobState::kFailed);
  EXPECT_THAT(answer.error, HasSubstr("RESOURCE_EXHAUSTED"));
  EXPECT_THAT(answer.error, HasSubstr("2.5s"));
  EXPECT_EQ(store->Get(job->id)->work_done, 3);
  EXPECT_EQ(store->Get(job->id)->unit_seconds, 3);
}

TEST(JobLimits, FailAJobWithTooManyRecordsAndEndAsUsualAtTheLimit) {
  const Toy toy{.chains = 3, .steps = 4};
  std::int64_t all = 0;
  {
    const auto store = MemoryStore();
    Scheduler scheduler(*store, ToyFactory({{"toy", toy}}), OneWorker({}));
    ASSERT_TRUE(scheduler.Start().ok());
    all = std::ssize(AwaitEnd(scheduler, *store, SubmitAs(scheduler, "")->id).records);
  }
  for (const auto& [limit, end] :
       {std::pair{all, JobState::kSucceeded}, std::pair{all / 2, JobState::kFailed}}) {
    JobLimits limits;
    limits.records = limit;
    SchedulerOptions options = OneWorker(limits);
    options.workers = 3;
    const auto store = MemoryStore();
    Scheduler scheduler(*store, ToyFactory({{"toy", toy}}), options);
    ASSERT_TRUE(scheduler.Start().ok());
    EXPECT_EQ(AwaitEnd(scheduler, *store, SubmitAs(scheduler, "")->id).state, end);
  }
}

TEST(JobLimits, OwnersTakeTurnsWhateverTheNumberOfTheirJobs) {
  absl::Notification submitted;
  std::string turns;
  const auto toy = [&](char name) {
    Toy made{.chains = 1, .steps = 2};
    made.on_run = [&turns, &submitted, name](UnitId, const StopRequested&) {
      submitted.WaitForNotification();
      turns += name;
      return absl::OkStatus();
    };
    return made;
  };
  const auto store = MemoryStore();
  SchedulerOptions options = OneWorker({});
  options.clock = absl::UnixEpoch;  // all units take equally long
  Scheduler scheduler(
      *store, ToyFactory({{"a", toy('a')}, {"b", toy('b')}, {"c", toy('c')}, {"x", toy('x')}}),
      options);
  ASSERT_TRUE(scheduler.Start().ok());
  std::string last;
  for (const char* name : {"a", "b", "c"}) last = SubmitAs(scheduler, "anna", name)->id;
  const std::string others = SubmitAs(scheduler, "boris", "x")->id;
  submitted.Notify();
  AwaitEnd(scheduler, *store, last);
  AwaitEnd(scheduler, *store, others);
  // Boris's one job has every second turn, but for the unit that was taken before he came.
  EXPECT_THAT(turns, ::testing::AnyOf(::testing::StartsWith("abxcx"), ::testing::StartsWith("axbx"),
                                      ::testing::StartsWith("abxax")));
}

}  // namespace
}  // namespace celt::jobs
