#include "server/plans/lyapunov_schedule.h"

#include <vector>

#include "gtest/gtest.h"

namespace celt::plans {
namespace {

struct Case {
  std::int64_t iterates, orbits, transient, unit;
};

const std::vector<Case> kCases = {
    {100'000, 8, 2000, 125},
    {100'003, 8, 2000, 125},
    {8, 8, 0, 125},
    {9, 8, 1, 1},
    {1, 1, 0, 1},
    {7, 1, 10, 3},
    {1000, 7, 13, 5},
    {4096, 4096, 5, 31},
    {5000, 70, 0, 1},
};

TEST(LyapunovSchedule, MeasuresExactlyWhatWasAsked) {
  for (const Case& c : kCases) {
    const LyapunovSchedule schedule(c.iterates, c.orbits, c.transient, c.unit);
    std::int64_t measured = 0;
    for (std::int64_t orbit = 0; orbit < c.orbits; ++orbit) {
      std::int64_t transient = 0;
      for (std::int64_t step = 0; step < schedule.steps(); ++step) {
        const std::int64_t iterates = schedule.Iterates(step, orbit);
        EXPECT_LE(iterates, c.unit);
        (schedule.IsTransient(step) ? transient : measured) += iterates;
      }
      EXPECT_EQ(transient, c.transient);
    }
    EXPECT_EQ(measured, c.iterates) << c.iterates << " over " << c.orbits;
  }
}

TEST(LyapunovSchedule, GivesOrbitsOfOneKindEquallyMany) {
  const LyapunovSchedule schedule(1003, 8, 50, 7);
  EXPECT_EQ(schedule.first_short_orbit(), 3);
  for (std::int64_t step = 0; step < schedule.steps(); ++step) {
    for (const std::int64_t orbit : {1, 2}) {
      EXPECT_EQ(schedule.Iterates(step, orbit), schedule.Iterates(step, 0));
    }
    for (const std::int64_t orbit : {4, 7}) {
      EXPECT_EQ(schedule.Iterates(step, orbit), schedule.Iterates(step, 3));
    }
  }
}

TEST(LyapunovSchedule, EndsWithARoundAndAllBatchesComplete) {
  for (const Case& c : kCases) {
    const LyapunovSchedule schedule(c.iterates, c.orbits, c.transient, c.unit);
    EXPECT_TRUE(schedule.EndsRound(schedule.steps() - 1));
    EXPECT_EQ(schedule.BatchesComplete(schedule.steps() - 1), schedule.batches());
    for (std::int64_t step = 0; schedule.IsTransient(step); ++step) {
      EXPECT_FALSE(schedule.EndsRound(step));
    }
  }
}

TEST(LyapunovSchedule, LeavesNoBatchEmpty) {
  for (const Case& c : kCases) {
    const LyapunovSchedule schedule(c.iterates, c.orbits, c.transient, c.unit);
    std::vector<std::int64_t> iterates(schedule.blocks() * schedule.batches());
    for (std::int64_t step = 0; step < schedule.steps(); ++step) {
      if (schedule.IsTransient(step)) continue;
      for (std::int64_t orbit = 0; orbit < c.orbits; ++orbit) {
        iterates[schedule.BatchOf(step) * schedule.blocks() + schedule.BlockOf(orbit)] +=
            schedule.Iterates(step, orbit);
      }
    }
    for (const std::int64_t batch : iterates) EXPECT_GT(batch, 0) << c.iterates << ", " << c.orbits;
  }
}

TEST(LyapunovSchedule, TellsSixtyFourTimesHowItStands) {
  const LyapunovSchedule schedule(100'000, 8, 2000, 10);
  int records = 0;
  for (std::int64_t step = 0; step < schedule.steps(); ++step) records += schedule.EndsRound(step);
  EXPECT_EQ(records, 64);
}

TEST(LyapunovSchedule, StaysExactAtTheGreatestLength) {
  // Too many steps to add up: the ends of the sum tell, and that no step is out of bounds.
  for (const std::int64_t orbits : {1, 3}) {
    constexpr std::int64_t kUnit = 31;
    const LyapunovSchedule schedule(kMaxIterates, orbits, 0, kUnit);
    for (const std::int64_t step : {std::int64_t{0}, schedule.steps() / 2, schedule.steps() - 1}) {
      EXPECT_GE(schedule.Iterates(step, 0), kUnit - 1);
      EXPECT_LE(schedule.Iterates(step, 0), kUnit);
    }
    EXPECT_GE(schedule.steps() * kUnit, kMaxIterates / orbits);
  }
}

}  // namespace
}  // namespace celt::plans
