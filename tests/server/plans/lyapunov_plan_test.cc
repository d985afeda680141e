#include "server/plans/lyapunov_plan.h"

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "gmock/gmock.h"
#include "google/protobuf/text_format.h"
#include "gtest/gtest.h"
#include "jobs/scheduler_testing.h"
#include "server/plans/factory.h"
#include "server/plans/lyapunov_state.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

using ::testing::SizeIs;

v1::JobSpec Resolve(const std::string& text) {
  v1::JobSpec spec;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &spec)) << text;
  const auto resolved = ResolveSpec(spec);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.value_or(v1::JobSpec());
}

v1::JobSpec Henon(const std::string& lyapunov) {
  return Resolve("system { name: 'henon3d' } lyapunov { " + lyapunov + " }");
}

struct Answer {
  std::vector<std::string> records;
  std::string result;
  double work = 0;
};

/// Unit after unit in the plan's order.
Answer RunAll(const jobs::Plan& plan) {
  Answer answer;
  std::map<std::int64_t, std::string> checkpoints;
  std::string state;
  for (jobs::UnitId unit; unit.step < plan.steps(); ++unit.step) {
    for (unit.chain = 0; unit.chain < plan.chains(); ++unit.chain) {
      auto output = plan.Run(unit, checkpoints[unit.chain], [] { return false; });
      EXPECT_TRUE(output.ok()) << output.status();
      if (!output.ok()) return answer;
      checkpoints[unit.chain] = output->checkpoint;
      answer.work += output->work;
      auto collected = plan.Collect(unit, state, output->payload);
      EXPECT_TRUE(collected.ok()) << collected.status();
      if (!collected.ok()) return answer;
      state = collected->state;
      answer.records.insert(answer.records.end(), collected->records.begin(),
                            collected->records.end());
    }
  }
  answer.result = plan.Finish(state).value_or("");
  return answer;
}

Answer RunAll(const v1::JobSpec& spec, std::int64_t group_size = 0) {
  const auto plan = LyapunovPlan::Make(spec, group_size);
  EXPECT_TRUE(plan.ok()) << plan.status();
  return RunAll(**plan);
}

v1::LyapunovResult ResultOf(const Answer& answer) {
  v1::Result result;
  EXPECT_TRUE(result.ParseFromString(answer.result));
  return result.lyapunov();
}

v1::LyapunovRecord RecordOf(const std::string& bytes) {
  v1::Record record;
  EXPECT_TRUE(record.ParseFromString(bytes));
  return record.lyapunov();
}

TEST(LyapunovPlan, MakesChainsOfEightOrbits) {
  EXPECT_EQ((*LyapunovPlan::Make(Henon("orbits: 1")))->chains(), 1);
  EXPECT_EQ((*LyapunovPlan::Make(Henon("orbits: 8")))->chains(), 1);
  EXPECT_EQ((*LyapunovPlan::Make(Henon("")))->chains(), 2);
  EXPECT_EQ((*LyapunovPlan::Make(Henon("orbits: 100")))->chains(), 13);
}

TEST(LyapunovPlan, MeasuresExactlyWhatWasAskedAndSaysSo) {
  const v1::JobSpec spec = Henon("orbits: 7 iterates: 10003 transient: 100");
  const Answer answer = RunAll(spec);
  EXPECT_EQ(ResultOf(answer).iterates(), 10003);
  EXPECT_EQ(ResultOf(answer).orbits(), 7);
  EXPECT_EQ(answer.work, 10003 + 7 * 100);
  EXPECT_EQ(answer.work, (*LyapunovPlan::Make(spec))->work().total);
}

TEST(LyapunovPlan, DoesNotShowHowOrbitsAreGrouped) {
  const v1::JobSpec spec = Henon("orbits: 7 iterates: 10003 transient: 100");
  const Answer all = RunAll(spec, 7);
  EXPECT_THAT(all.records, SizeIs(12));
  for (const std::int64_t group : {1, 2, 4, 16}) {
    const Answer grouped = RunAll(spec, group);
    EXPECT_EQ(grouped.records, all.records) << "groups of " << group;
    EXPECT_EQ(grouped.result, all.result) << "groups of " << group;
  }
}

TEST(LyapunovPlan, DoesNotShowHowManyThreadsRunItNorAnInterruption) {
  const v1::JobSpec spec = Henon("orbits: 20 iterates: 20000 transient: 500");
  const Answer expected = RunAll(spec);
  for (const int workers : {1, 3}) {
    const auto store = jobs::MemoryStore();
    jobs::SchedulerOptions options;
    options.workers = workers;
    std::string id;
    {
      jobs::Scheduler first(*store, MakePlan, options);
      ASSERT_TRUE(first.Start().ok());
      id = jobs::Submit(first, Serialize(spec));
      // Somewhere on the way; where exactly must not matter.
      jobs::AwaitJob(first, id, [&] { return store->Get(id)->last_sequence >= 5; });
    }
    jobs::Scheduler second(*store, MakePlan, options);
    ASSERT_TRUE(second.Start().ok());
    const jobs::Answer answer = jobs::AwaitEnd(second, *store, id);
    EXPECT_EQ(answer.records, expected.records) << workers << " workers";
    EXPECT_EQ(answer.result, expected.result) << workers << " workers";
  }
}

TEST(LyapunovPlan, FindsTheSpectrumOfTheHenonMap) {
  // 0.0085, 0.0000, -0.3652 at M2 = 0.815 (Gonchenko et al.), sum ln 0.7 exactly; three standard
  // errors each, and half a unit of the last digit known.
  const v1::LyapunovResult result =
      ResultOf(RunAll(Resolve("system { name: 'henon3d' parameters { key: 'm2' value: 0.815 } } "
                              "lyapunov { iterates: 400000 }")));
  const std::vector<double> known = {0.00848, 0.0000, -0.36516};
  for (int i = 0; i < 3; ++i) {
    const double error = result.standard_error_per_iterate(i);
    EXPECT_GT(error, 0);
    EXPECT_NEAR(result.exponents_per_iterate(i), known[i], 3 * error + 5e-5);
  }
  // ln R of the QR factorisation is rounded to some 1e-16 relative an iterate, and the sum of 4e5
  // by no more than 1e-11.
  EXPECT_NEAR(result.sum_per_iterate(), std::log(0.7), 1e-11);
  EXPECT_EQ(result.mean_return_time(), 1);
  EXPECT_EQ(result.conditions_size(), 4);
}

TEST(LyapunovPlan, EndsItsHistoryAtTheResult) {
  const Answer answer = RunAll(Henon("iterates: 6400 transient: 10"));
  const v1::LyapunovRecord last = RecordOf(answer.records.back());
  const v1::LyapunovResult result = ResultOf(answer);
  EXPECT_EQ(last.iterates(), 6400);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(last.exponents_per_iterate(i), result.exponents_per_iterate(i));
    EXPECT_EQ(last.standard_error_per_iterate(i), result.standard_error_per_iterate(i));
  }
}

TEST(LyapunovPlan, GivesNoStandardErrorBeforeItHasFourBatches) {
  const Answer answer = RunAll(Henon("orbits: 1 iterates: 6400 transient: 10"));
  ASSERT_THAT(answer.records, SizeIs(64));
  // Sixteen batches to an orbit: the fourth begins with the 13th of 64 rounds.
  EXPECT_EQ(RecordOf(answer.records[11]).standard_error_per_iterate_size(), 0);
  EXPECT_EQ(RecordOf(answer.records[12]).standard_error_per_iterate_size(), 3);
}

TEST(LyapunovPlan, SaysHowAccurateTheMapWasAndWhatTheAttractorIs) {
  const v1::LyapunovResult stone =
      ResultOf(RunAll(Resolve("lyapunov { iterates: 8000 transient: 200 }")));
  EXPECT_EQ(stone.accuracy().sample(), 32);
  // What the fast engine states at the default tolerance of 1e-11; 32 points find most of it.
  EXPECT_GT(stone.accuracy().map_error(), 5e-12);
  EXPECT_LT(stone.accuracy().map_error(), 5e-11);
  EXPECT_LT(stone.accuracy().jacobian_error(), 3e-10);
  EXPECT_GT(stone.accuracy().drift(), 0);
  ASSERT_EQ(stone.map_error_per_iterate_size(), 3);
  for (const double error : stone.map_error_per_iterate()) {
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 1e-7);
  }
  EXPECT_EQ(stone.accuracy().warnings_size(), 0);
  EXPECT_EQ(stone.regime(), v1::REGIME_PSEUDO_HYPERBOLIC_CANDIDATE);
}

TEST(LyapunovPlan, WarnsWhereTheMapIsWorseThanTheAnswerClaims) {
  // On a stable cycle the scatter goes to nothing; a map good to 1e-4 is then the larger error.
  const v1::LyapunovResult result = ResultOf(RunAll(
      Resolve("system { parameters { key: 'energy' value: 747 } } numerics { tolerance: 1e-5 "
              "} lyapunov { iterates: 1600 transient: 2000 }")));
  EXPECT_GT(result.accuracy().warnings_size(), 0);
  EXPECT_EQ(result.regime(), v1::REGIME_PERIODIC);
}

TEST(LyapunovPlan, FindsNoErrorInAFormula) {
  const v1::LyapunovResult result = ResultOf(RunAll(Henon("iterates: 6400 transient: 10")));
  EXPECT_EQ(result.accuracy().sample(), 26);
  EXPECT_EQ(result.accuracy().map_error(), 0);
  EXPECT_EQ(result.map_error_per_iterate(0), 0);
  EXPECT_EQ(result.accuracy().warnings_size(), 0);
}

TEST(LyapunovPlan, GivesNoStandardErrorOfASingleIterate) {
  const Answer answer = RunAll(Henon("orbits: 1 iterates: 1 transient: 0"));
  EXPECT_THAT(answer.records, SizeIs(1));
  const v1::LyapunovResult result = ResultOf(answer);
  EXPECT_EQ(result.exponents_per_iterate_size(), 3);
  EXPECT_EQ(result.standard_error_per_iterate_size(), 0);
  EXPECT_FALSE(result.has_standard_error_sum_per_iterate());
  EXPECT_FALSE(result.conditions(0).has_margin());
}

TEST(LyapunovPlan, KeepsItsStateSmallHoweverLongTheJob) {
  const auto plan = LyapunovPlan::Make(Henon("orbits: 4096 iterates: 1000000000"));
  ASSERT_TRUE(plan.ok());
  std::string state;
  const auto output = (*plan)->Run({0, 0}, "", [] { return false; });
  ASSERT_TRUE(output.ok()) << output.status();
  EXPECT_LT(output->checkpoint.size(), 16U * 1024);
  // The first measured step, whichever it is, with the sums of a group of orbits.
  LyapunovTally tally;
  tally.sums.resize(8, {.iterates = 1, .time = 1, .log_stretch = Point::Ones(3)});
  tally.sample.resize(64, {.point = Point::Ones(3), .frame = SquareMatrix::Identity(3, 3)});
  const auto collected = (*plan)->Collect({(*plan)->steps() - 2, 0}, "", EncodeTally(tally));
  ASSERT_TRUE(collected.ok()) << collected.status();
  EXPECT_LT(collected->state.size(), 16U * 1024);
}

TEST(LyapunovPlan, StopsInsideAUnit) {
  const auto plan = LyapunovPlan::Make(Henon("orbits: 1 iterates: 1000000"));
  int asked = 0;
  const auto output = (*plan)->Run({0, 0}, "", [&] { return ++asked > 10; });
  EXPECT_TRUE(absl::IsCancelled(output.status())) << output.status();
  EXPECT_LT(asked, 20);
}

TEST(LyapunovPlan, SaysThatAnOrbitWasLost) {
  // Far from the attractor the map's quadratic term sends every orbit to infinity.
  const auto plan = LyapunovPlan::Make(Henon("start { x: [50, 50, 50] }"));
  const auto output = (*plan)->Run({0, 0}, "", [] { return false; });
  EXPECT_TRUE(absl::IsOutOfRange(output.status())) << output.status();
}

TEST(LyapunovPlan, RefusesADamagedCheckpoint) {
  const auto plan = LyapunovPlan::Make(Henon(""));
  const auto never = [] { return false; };
  EXPECT_TRUE(absl::IsDataLoss((*plan)->Run({1, 0}, "nonsense", never).status()));
  EXPECT_TRUE(absl::IsDataLoss((*plan)->Run({1, 0}, "", never).status()));
}

TEST(LyapunovState, ComesBackToTheLastBit) {
  FramedOrbit orbit;
  orbit.point = Eigen::Vector3d(1.0 / 3, -0.0, std::numeric_limits<double>::denorm_min());
  orbit.frame = Eigen::Matrix3d{{1.0 / 7, 2, 3}, {4, 5, 6}, {7, 8, 1e308}};
  const auto orbits = DecodeOrbits(EncodeOrbits(std::vector{orbit, orbit}));
  ASSERT_TRUE(orbits.ok()) << orbits.status();
  ASSERT_THAT(*orbits, SizeIs(2));
  EXPECT_EQ((*orbits)[1].point, orbit.point);
  EXPECT_TRUE(std::signbit((*orbits)[1].point[1]));
  EXPECT_EQ((*orbits)[1].frame, orbit.frame);
}

}  // namespace
}  // namespace celt::plans
