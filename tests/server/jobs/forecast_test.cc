#include "server/jobs/forecast.h"

#include <vector>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "jobs/scheduler_testing.h"
#include "jobs/toy_plan.h"

namespace celt::jobs {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

/// 100 efforts of 2 seconds each before anything was measured; keeps one thread busy.
Load Hundred() {
  Load load;
  load.kind = "hundred";
  load.effort = 100;
  load.seconds = 2;
  load.most_units = 10;
  load.iterates = 50;
  return load;
}

TEST(Forecast, GoesByTheTableUntilAUnitWasMeasured) {
  Forecast forecast(4);
  EXPECT_EQ(forecast.Of(Hundred()).alone, absl::Seconds(200));
  EXPECT_EQ(forecast.Of(Hundred()).most_units, 10);
  EXPECT_EQ(forecast.Of(Hundred()).iterates, 50);
  EXPECT_THAT(forecast.Paces(), IsEmpty());
  forecast.Begin("job", Hundred(), 0);
  forecast.CountUnit("job", 0.5, absl::Seconds(150));
  EXPECT_EQ(forecast.Of(Hundred()).alone, absl::Seconds(300));
  EXPECT_THAT(forecast.Paces(), ElementsAre(Pair("hundred", 3)));
}

TEST(Forecast, ForgetsWhatWasMeasuredLongAgo) {
  Forecast forecast(1);
  forecast.Begin("job", Hundred(), 0);
  forecast.CountUnit("job", 0.01, absl::Seconds(100));
  for (int i = 0; i < 300; ++i) forecast.CountUnit("job", 0.01, absl::Seconds(1));
  // A share 0.95^300 = 2e-7 of the first unit's 100 s is left among 20 units.
  EXPECT_NEAR(forecast.Paces().at("hundred"), 1, 1e-5);
}

TEST(Forecast, CountsWhatIsLeft) {
  Forecast forecast(1);
  forecast.Begin("job", Hundred(), 0.25);
  EXPECT_EQ(forecast.Of("job")->alone, absl::Seconds(150));
  forecast.CountUnit("job", 0.5, absl::Seconds(100));
  EXPECT_EQ(forecast.Of("job")->alone, absl::Seconds(50));
  forecast.CountUnit("job", 0.5, absl::Seconds(100));
  EXPECT_EQ(forecast.Of("job")->alone, absl::ZeroDuration()) << "it took longer than it said";
  forecast.End("job");
  EXPECT_FALSE(forecast.Of("job").has_value());
}

TEST(Forecast, DividesAJobAmongTheThreadsThatItCanUse) {
  Load load = Hundred();
  load.threads = 4;
  EXPECT_EQ(Forecast(2).Of(load).alone, absl::Seconds(100));
  EXPECT_EQ(Forecast(8).Of(load).alone, absl::Seconds(50));
}

TEST(Forecast, QueueIsWhatIsLeftOfTheOtherJobs) {
  Load other = Hundred();
  other.kind = "other";
  Forecast forecast(2);
  forecast.Begin("a", Hundred(), 0);
  forecast.Begin("b", Hundred(), 0.5);
  forecast.Begin("c", other, 0.9);
  EXPECT_EQ(forecast.Of(Hundred()).queue, absl::Seconds(200 + 100 + 20) / 2);
  EXPECT_EQ(forecast.Of("a")->queue, absl::Seconds(100 + 20) / 2);
  forecast.End("b");
  EXPECT_EQ(forecast.Of("a")->queue, absl::Seconds(20) / 2);
}

/// Every look at the clock is a second later: each unit takes one.
SchedulerOptions SecondsForUnits() {
  SchedulerOptions options;
  options.workers = 1;
  options.clock = [now = std::make_shared<absl::Time>(absl::UnixEpoch())] {
    return *now += absl::Seconds(1);
  };
  return options;
}

TEST(Forecast, OfASchedulerComesFromItsUnitsAndLastsOverARestart) {
  const auto store = MemoryStore();
  const PlanFactory factory =
      ToyFactory({{"toy", {.chains = 1, .steps = 3}}, {"long", {.chains = 2, .steps = 20}}});
  {
    Scheduler scheduler(*store, factory, SecondsForUnits());
    ASSERT_TRUE(scheduler.Start().ok());
    EXPECT_EQ(scheduler.Foretell("long")->alone, absl::ZeroDuration()) << "nothing is known yet";
    const auto job = TrySubmit(scheduler, "toy");
    AwaitEnd(scheduler, *store, job->id);
    EXPECT_EQ(scheduler.Foretell("long")->alone, absl::Seconds(40));
    EXPECT_EQ(scheduler.Foretell("long")->most_units, 40);
  }
  Scheduler restarted(*store, factory, SecondsForUnits());
  ASSERT_TRUE(restarted.Start().ok());
  EXPECT_EQ(restarted.Foretell("long")->alone, absl::Seconds(40));
  EXPECT_EQ(store->List({}, 10, "")->jobs.size(), 1U) << "to foretell is to accept nothing";
  EXPECT_TRUE(absl::IsInvalidArgument(restarted.Foretell("no such toy").status()));
}

TEST(Forecast, OfAnUnfinishedJobGoesOnAfterARestart) {
  const auto store = MemoryStore();
  Toy toy{.chains = 1, .steps = 4};
  toy.on_run = [](UnitId unit, const StopRequested& stopped) {
    if (unit.step < 3) return absl::OkStatus();
    while (!stopped()) std::this_thread::yield();
    return absl::CancelledError("stopped");
  };
  std::string id;
  {
    Scheduler scheduler(*store, ToyFactory({{"toy", toy}}), SecondsForUnits());
    ASSERT_TRUE(scheduler.Start().ok());
    id = Submit(scheduler, "toy");
    AwaitJob(scheduler, id, [&] { return store->Get(id)->work_done == 3; });
    scheduler.Shutdown();
  }
  SchedulerOptions options = SecondsForUnits();
  options.load = [](std::string_view, const Plan&) { return Hundred(); };
  Scheduler restarted(*store, ToyFactory({{"toy", toy}}), options);
  ASSERT_TRUE(restarted.Start().ok());
  EXPECT_EQ(restarted.forecast().Of(id)->alone, absl::Seconds(50)) << "a quarter is left of 200 s";
}

}  // namespace
}  // namespace celt::jobs
