#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/status.h"
#include "celt/v1/job.pb.h"
#include "google/protobuf/text_format.h"
#include "gtest/gtest.h"
#include "jobs/scheduler_testing.h"
#include "server/plans/factory.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::plans {

inline v1::JobSpec ParseSpec(const std::string& text) {
  v1::JobSpec spec;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &spec)) << text;
  return spec;
}

/// A specification with its defaults filled in.
inline v1::JobSpec Resolved(const std::string& text) {
  const auto resolved = ResolveSpec(ParseSpec(text));
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.value_or(v1::JobSpec());
}

/// What a plan gave, unit after unit, each from what a store would have kept of those before.
struct PlanRun {
  std::vector<std::string> bytes;  ///< of the records
  std::vector<v1::Record> records;
  std::string result_bytes;
  v1::Result result;
  absl::Status status;  ///< of the unit that failed
  double work = 0;
  std::int64_t units = 0;
  std::size_t largest_checkpoint = 0;
};

inline PlanRun RunPlan(const v1::JobSpec& resolved) {
  PlanRun run;
  const auto plan = MakePlan(Serialize(resolved));
  EXPECT_TRUE(plan.ok()) << plan.status();
  if (!plan.ok()) return run;
  std::map<std::int64_t, std::string> checkpoints;
  std::map<std::int64_t, bool> ended;
  std::string state;
  for (jobs::UnitId unit; unit.step < (*plan)->steps(); ++unit.step) {
    bool idle = true;
    for (unit.chain = 0; unit.chain < (*plan)->chains(); ++unit.chain) {
      if (ended[unit.chain]) continue;
      idle = false;
      const auto output = (*plan)->Run(unit, checkpoints[unit.chain], [] { return false; });
      run.status = output.status();
      if (!output.ok()) return run;
      ++run.units;
      run.work += output->work;
      run.largest_checkpoint = std::max(run.largest_checkpoint, output->checkpoint.size());
      checkpoints[unit.chain] = output->checkpoint;
      ended[unit.chain] = output->chain_ended;
      const auto collected = (*plan)->Collect(unit, state, output->payload);
      EXPECT_TRUE(collected.ok()) << collected.status();
      if (!collected.ok()) return run;
      state = collected->state;
      for (const std::string& record : collected->records) {
        run.bytes.push_back(record);
        run.records.push_back(Parse<v1::Record>(record).value());
      }
    }
    if (idle) break;
  }
  const auto result = (*plan)->Finish(state);
  run.status = result.status();
  run.result_bytes = result.value_or("");
  run.result = Parse<v1::Result>(run.result_bytes).value();
  return run;
}

inline PlanRun RunPlan(const std::string& text) { return RunPlan(Resolved(text)); }

/// The same through a scheduler that is stopped after `interrupted_after` records, and another one
/// that goes on.
inline void ExpectSameBytesWhenInterrupted(const v1::JobSpec& resolved, int workers,
                                           std::int64_t interrupted_after) {
  const PlanRun expected = RunPlan(resolved);
  const auto store = jobs::MemoryStore();
  jobs::SchedulerOptions options;
  options.workers = workers;
  std::string id;
  {
    jobs::Scheduler first(*store, MakePlan, options);
    ASSERT_TRUE(first.Start().ok());
    id = jobs::Submit(first, Serialize(resolved));
    jobs::AwaitJob(first, id, [&] { return store->Get(id)->last_sequence >= interrupted_after; });
  }
  jobs::Scheduler second(*store, MakePlan, options);
  ASSERT_TRUE(second.Start().ok());
  const jobs::Answer answer = jobs::AwaitEnd(second, *store, id);
  EXPECT_EQ(answer.records, expected.bytes) << workers << " workers";
  EXPECT_EQ(answer.result, expected.result_bytes) << workers << " workers";
}

/// A specification that is refused, and how the message begins and what is in it.
struct BadSpecification {
  const char* text;
  const char* beginning;
  const char* part;
};

inline void ExpectRefused(const BadSpecification& bad) {
  SCOPED_TRACE(bad.text);
  const auto resolved = ResolveSpec(ParseSpec(bad.text));
  EXPECT_EQ(resolved.status().code(), absl::StatusCode::kInvalidArgument) << resolved.status();
  const std::string message(resolved.status().message());
  EXPECT_EQ(message.rfind(bad.beginning, 0), 0U) << message;
  EXPECT_NE(message.find(bad.part), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << "more than a line: " << message;
}

}  // namespace celt::plans
