#include "server/plans/lyapunov_schedule.h"

#include <limits>
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

TEST(LyapunovSchedule, EndsWithARoundInTheLastBatch) {
  for (const Case& c : kCases) {
    const LyapunovSchedule schedule(c.iterates, c.orbits, c.transient, c.unit);
    EXPECT_TRUE(schedule.EndsRound(schedule.steps() - 1));
    EXPECT_EQ(schedule.BatchOf(schedule.steps() - 1), schedule.batches() - 1);
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

int CountRecords(const LyapunovSchedule& schedule) {
  int records = 0;
  for (std::int64_t step = 0; step < schedule.steps(); ++step) records += schedule.EndsRound(step);
  return records;
}

TEST(LyapunovSchedule, TellsUpToSixtyFourTimesHowItStands) {
  EXPECT_EQ(CountRecords({100'000, 8, 2000, 10}), 64);
  // Shorter runs less often: a round has a hundred iterates of an orbit, or there are eight rounds.
  EXPECT_EQ(CountRecords({20'000, 16, 2000, 1000}), 12);
  EXPECT_EQ(CountRecords({1000, 16, 2000, 1000}), 8);
  EXPECT_EQ(CountRecords({3, 1, 0, 1000}), 2);
}

TEST(LyapunovSchedule, MakesSixteenBatchesOrAsManyAsThereAreOrbits) {
  for (const std::int64_t orbits : {1, 2, 4, 8, 16, 64}) {
    const LyapunovSchedule schedule(100'000, orbits, 0, 1000);
    EXPECT_EQ(schedule.batches() * schedule.blocks(), std::max<std::int64_t>(orbits, 16));
  }
  const LyapunovSchedule odd(100'000, 5, 0, 1000);
  EXPECT_EQ(odd.batches(), 4) << "a power of two";
}

TEST(LyapunovSchedule, SamplesOrbitsAndRoundsEvenly) {
  for (const Case& c : kCases) {
    const LyapunovSchedule schedule(c.iterates, c.orbits, c.transient, c.unit);
    int points = 0;
    for (std::int64_t step = 0; step < schedule.steps(); ++step) {
      for (std::int64_t orbit = 0; orbit < c.orbits; ++orbit)
        points += schedule.IsSampled(step, orbit);
    }
    EXPECT_GT(points, 0) << c.iterates << " over " << c.orbits;
    EXPECT_LE(points, 2 * 64) << c.iterates << " over " << c.orbits;
  }
  // 62 rounds of 16 orbits, a point in 15: four or five an orbit.
  const LyapunovSchedule schedule(100'000, 16, 0, 10'000);
  for (std::int64_t orbit = 0; orbit < 16; ++orbit) {
    int points = 0;
    for (std::int64_t step = 0; step < schedule.steps(); ++step)
      points += schedule.IsSampled(step, orbit);
    EXPECT_GE(points, 4) << orbit;
    EXPECT_LE(points, 5) << orbit;
  }
}

TEST(LyapunovSchedule, StaysExactAtTheGreatestLength) {
  // Too many steps to add up: the ends of the sum tell, and that no step is out of bounds.
  for (const std::int64_t orbits : {1, 3}) {
    constexpr std::int64_t kUnit = 31;
    const LyapunovSchedule schedule(kMaxIterates, orbits, 0, kUnit);
    // The step at which (total mod steps)·step goes past 64 bits, for a single orbit.
    const std::int64_t far =
        std::numeric_limits<std::int64_t>::max() / (kMaxIterates % schedule.steps());
    for (const std::int64_t step :
         {std::int64_t{0}, far, schedule.steps() / 2, schedule.steps() - 1}) {
      EXPECT_GE(schedule.Iterates(step, 0), kUnit - 1);
      EXPECT_LE(schedule.Iterates(step, 0), kUnit);
    }
    EXPECT_GE(schedule.steps() * kUnit, kMaxIterates / orbits);
  }
}

}  // namespace
}  // namespace celt::plans
