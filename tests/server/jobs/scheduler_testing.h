#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "gtest/gtest.h"
#include "jobs/toy_plan.h"
#include "server/jobs/scheduler.h"
#include "server/jobs/sqlite_store.h"

namespace celt::jobs {

/// What a job leaves behind.
struct Answer {
  JobState state = JobState::kQueued;
  std::string error;
  std::string result;
  std::vector<std::string> records;

  bool operator==(const Answer&) const = default;
};

inline void PrintTo(const Answer& answer, std::ostream* out) {
  *out << "state " << static_cast<int>(answer.state) << ", " << answer.error << ", "
       << answer.result << ", " << ::testing::PrintToString(answer.records);
}

inline SchedulerOptions Workers(int workers) {
  SchedulerOptions options;
  options.workers = workers;
  options.run_ahead = 5;
  return options;
}

/// Waits until the condition holds, looking whenever the job has changed.
template <class Condition>
void AwaitJob(Scheduler& scheduler, const std::string& id, Condition condition) {
  struct Signal {
    std::mutex mutex;
    std::condition_variable changed;
    std::uint64_t changes = 0;
  };
  // Held by the callback too, which may be under way when this returns.
  const auto signal = std::make_shared<Signal>();
  const auto subscription = scheduler.notifier().Subscribe(id, [signal] {
    const std::lock_guard lock(signal->mutex);
    ++signal->changes;
    signal->changed.notify_all();
  });
  std::uint64_t seen = 0;
  while (!condition()) {
    std::unique_lock lock(signal->mutex);
    signal->changed.wait(lock, [&] { return signal->changes > seen; });
    seen = signal->changes;
  }
}

inline Answer AnswerOf(const JobStore& store, const std::string& id) {
  Answer answer;
  const auto job = store.Get(id);
  const auto records = store.Records(id, 0, std::size_t{1} << 30);
  if (!job.ok() || !records.ok()) return answer;
  answer.state = job->state;
  answer.error = job->error.ToString();
  answer.result = job->result;
  for (const StoredRecord& record : *records) answer.records.push_back(record.bytes);
  return answer;
}

inline Answer AwaitEnd(Scheduler& scheduler, const JobStore& store, const std::string& id) {
  AwaitJob(scheduler, id, [&] {
    const auto job = store.Get(id);
    return !job.ok() || HasEnded(job->state);
  });
  return AnswerOf(store, id);
}

inline std::unique_ptr<SqliteStore> MemoryStore() { return *SqliteStore::Open(":memory:"); }

/// Submits a job of its own, whatever is known already.
inline absl::StatusOr<Job> TrySubmit(Scheduler& scheduler, const std::string& specification,
                                     const std::string& request_id = "") {
  return scheduler.Submit(
      {.specification = specification, .owner = {}, .request_id = request_id, .fresh = true});
}

/// The same; gives the id.
inline std::string Submit(Scheduler& scheduler, const std::string& specification,
                          const std::string& request_id = "") {
  const auto job = TrySubmit(scheduler, specification, request_id);
  EXPECT_TRUE(job.ok()) << job.status();
  return job.ok() ? job->id : "";
}

/// Chains of different lengths, so that the fold has to skip.
inline Toy Uneven() { return {.chains = 7, .steps = 9, .lengths = {{2, 3}, {5, 1}}}; }

/// The answer by the definition: unit after unit in the plan's order.
inline Answer ByDefinition(const Toy& toy) {
  const ToyPlan plan(toy);
  std::map<std::int64_t, UnitOutput> chains;
  std::string state;
  Answer answer;
  for (UnitId unit; unit.step < plan.steps(); ++unit.step) {
    for (unit.chain = 0; unit.chain < plan.chains(); ++unit.chain) {
      UnitOutput& chain = chains[unit.chain];
      if (chain.chain_ended) continue;
      chain = *plan.Run(unit, chain.checkpoint, [] { return false; });
      Collected collected = *plan.Collect(unit, state, chain.payload);
      state = collected.state;
      answer.records.insert(answer.records.end(), collected.records.begin(),
                            collected.records.end());
    }
  }
  answer.state = JobState::kSucceeded;
  answer.error = absl::OkStatus().ToString();
  answer.result = *plan.Finish(state);
  return answer;
}

/// Waits inside a unit until it is told to stop.
inline absl::Status RunUntilStopped(const StopRequested& stop) {
  while (!stop()) std::this_thread::yield();
  return absl::CancelledError("stopped");
}

}  // namespace celt::jobs
