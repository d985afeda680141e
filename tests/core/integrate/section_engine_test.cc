#include "core/integrate/section_engine.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/integrate/section_event.h"
#include "core/integrate/sundials_section_engine.h"
#include "core/model/andoyer.h"
#include "gtest/gtest.h"
#include "tests/core/integrate/list_feed.h"
#include "tests/core/reference.h"

namespace celt {
namespace {

constexpr double kPi = std::numbers::pi;

CelticStone Stone() { return CelticStone{StoneParameters{}}; }

CrossingTask TaskAt(const SectionPoint& x) {
  const auto lifted = LiftToLevel(Stone(), 752, kPi, x);
  EXPECT_TRUE(lifted.ok()) << lifted.status();
  return {.state = lifted->state, .tangents = lifted->derivative};
}

std::vector<CrossingTask> ReferenceTasks(std::size_t count) {
  std::vector<CrossingTask> tasks;
  for (const ReferenceIterate& iterate : ReferenceIterates()) {
    if (tasks.size() < count) tasks.push_back(TaskAt(iterate.point));
  }
  return tasks;
}

/// Points of a grid over a level on which g goes both ways.
std::vector<CrossingTask> GridTasks(double angle) {
  std::vector<CrossingTask> tasks;
  for (const double l : {0.4, 2.1, 3.7}) {
    for (const double l_over_g : {-0.8, -0.2, 0.5}) {
      for (const double h_over_g : {-0.6, 0.3, 0.9}) {
        const auto lifted = LiftToLevel(Stone(), 752, angle, {l, l_over_g, h_over_g});
        if (lifted.ok()) tasks.push_back({.state = lifted->state, .tangents = lifted->derivative});
      }
    }
  }
  return tasks;
}

class SectionEngines : public testing::TestWithParam<Engine> {
 protected:
  std::unique_ptr<SectionEngine> Make(double tolerance) const {
    auto engine = MakeSectionEngine(Stone(), kPi, {.tolerance = tolerance, .engine = GetParam()});
    EXPECT_TRUE(engine.ok()) << engine.status();
    return *std::move(engine);
  }
};

TEST_P(SectionEngines, CrossTheWayTheyAreAskedTo) {
  constexpr double kAngle = 2.5;  // where orbits cross either way
  for (const Crossings way : {Crossings::kIncreasing, Crossings::kDecreasing}) {
    const SectionEvent event(kAngle, way);
    const auto engine =
        MakeSectionEngine(Stone(), event, {.tolerance = 1e-10, .engine = GetParam()});
    ListFeed feed(GridTasks(kAngle));
    (*engine)->Run(feed, Direction::kForward, Derivative::kNone);
    int crossed = 0;
    for (std::size_t i = 0; i < feed.crossings.size(); ++i) {
      if (!feed.statuses[i].ok()) continue;
      ++crossed;
      const StoneState& y = feed.crossings[i].state;
      EXPECT_GT(event.Side(y), 0);
      // The gradient carries the sign: what counts always grows.
      EXPECT_GT(event.Gradient(y).dot(Stone().Field(y)), 0);
    }
    EXPECT_GT(crossed, 3);
  }
}

TEST_P(SectionEngines, CrossBackwardWhereTheyCameFrom) {
  constexpr double kAngle = 2.5;  // where orbits cross either way
  const SectionEvent event(kAngle, Crossings::kDecreasing);
  const auto engine = MakeSectionEngine(Stone(), event, {.tolerance = 1e-11, .engine = GetParam()});
  ListFeed there(GridTasks(kAngle));
  (*engine)->Run(there, Direction::kForward, Derivative::kNone);
  // Where an orbit all but touches the section, neighbouring crossings may go unseen.
  const auto transversal = [&](const StoneState& y) {
    const double rate = event.Gradient(y).dot(Stone().Field(y)) / event.Side(y);  // |dg/dt|
    return rate > 2 && event.Side(y) > 0.3 * y.head<3>().norm();
  };
  int returned = 0;
  for (std::size_t i = 0; i < there.crossings.size(); ++i) {
    if (!there.statuses[i].ok() || !transversal(there.crossings[i].state)) continue;
    ListFeed on({{.state = there.crossings[i].state, .tangents = {}}});
    (*engine)->Run(on, Direction::kForward, Derivative::kNone);
    if (!on.statuses[0].ok() || !transversal(on.crossings[0].state)) continue;
    ListFeed back({{.state = on.crossings[0].state, .tangents = {}}});
    (*engine)->Run(back, Direction::kBackward, Derivative::kNone);
    ASSERT_TRUE(back.statuses[0].ok()) << back.statuses[0];
    // Tolerances add up over some hundred steps, and orbits stretch by up to a thousand.
    const StoneState& start = there.crossings[i].state;
    EXPECT_LT((back.crossings[0].state - start).norm(), 1e-6 * start.norm()) << i;
    ++returned;
  }
  EXPECT_GT(returned, 2);
}

TEST_P(SectionEngines, LandOnTheSectionToRounding) {
  ListFeed feed(ReferenceTasks(10));
  // Even a coarse integration ends on the section itself.
  Make(1e-7)->Run(feed, Direction::kForward, Derivative::kNone);
  const SectionEvent event(kPi);
  for (const Crossing& crossing : feed.crossings) {
    const double momentum = crossing.state.head<3>().norm();
    EXPECT_NEAR(event.Value(crossing.state), 0, 1e-13 * momentum);
    EXPECT_GT(event.Side(crossing.state), 0);
    EXPECT_GT(event.Gradient(crossing.state).dot(crossing.velocity), 0);
  }
}

TEST_P(SectionEngines, KeepBothIntegrals) {
  ListFeed feed(ReferenceTasks(10));
  constexpr double kTolerance = 1e-11;
  Make(kTolerance)->Run(feed, Direction::kForward, Derivative::kNone);
  for (const Crossing& crossing : feed.crossings) {
    // The gradient of H is some 20 times the energy over the momentum; a thousand steps at worst.
    EXPECT_NEAR(Stone().Energy(crossing.state), 752, 2e4 * kTolerance * 752);
    EXPECT_NEAR(crossing.state.tail<3>().norm(), 1, 1e3 * kTolerance);
  }
}

TEST_P(SectionEngines, GoBackToTheCrossingBefore) {
  ListFeed there(ReferenceTasks(5));
  const auto engine = Make(1e-12);
  engine->Run(there, Direction::kForward, Derivative::kJacobian);
  std::vector<CrossingTask> tasks;
  for (const Crossing& c : there.crossings)
    tasks.push_back({.state = c.state, .tangents = c.tangents});
  ListFeed back(tasks);
  engine->Run(back, Direction::kBackward, Derivative::kJacobian);
  const std::vector<CrossingTask> starts = ReferenceTasks(5);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    ASSERT_TRUE(back.statuses[i].ok()) << back.statuses[i];
    EXPECT_NEAR(back.crossings[i].time, there.crossings[i].time, 1e-9);
    // Tolerance times a thousand steps at worst, times the flow's stretching of about 30 on the way
    // back.
    EXPECT_LT((back.crossings[i].state - starts[i].state).norm(), 3e-8 * starts[i].state.norm());
    EXPECT_LT((back.crossings[i].tangents - starts[i].tangents).norm(),
              3e-7 * starts[i].tangents.norm());
  }
}

TEST_P(SectionEngines, GiveTheSameBitsWhateverElseIsInTheFeed) {
  const auto engine = Make(1e-9);
  ListFeed together(ReferenceTasks(4));
  engine->Run(together, Direction::kForward, Derivative::kJacobian);
  ListFeed alone({ReferenceTasks(4)[3]});
  engine->Run(alone, Direction::kForward, Derivative::kJacobian);
  EXPECT_EQ(together.crossings[3].state, alone.crossings[0].state);
  EXPECT_EQ(together.crossings[3].tangents, alone.crossings[0].tangents);
  EXPECT_EQ(together.crossings[3].time, alone.crossings[0].time);
}

TEST_P(SectionEngines, SayWhenAndWhereAnOrbitRunsOffToTheSingularity) {
  // γ₃ < 0 at the start: the stone hangs below its contact point, and rolls up the paraboloid for
  // ever.
  ListFeed feed({TaskAt({1, 0.9, -0.9}), ReferenceTasks(1)[0]});
  Make(1e-8)->Run(feed, Direction::kForward, Derivative::kNone);
  EXPECT_EQ(feed.statuses[0].code(), absl::StatusCode::kOutOfRange);
  const std::string message(feed.statuses[0].message());
  EXPECT_TRUE(message.starts_with("orbit lost at t = 3.")) << message;
  EXPECT_NE(message.find("(M, gamma) = ("), std::string::npos) << message;
  EXPECT_NE(message.find("gamma3 goes to 0"), std::string::npos) << message;
  EXPECT_TRUE(feed.statuses[1].ok()) << "the next orbit is not disturbed";
}

INSTANTIATE_TEST_SUITE_P(Engines, SectionEngines,
                         testing::Values(Engine::kCvode, Engine::kArkode, Engine::kFast));

absl::Status StatusUnder(const CrossingLimits& limits) {
  ListFeed feed(ReferenceTasks(1));
  SundialsSectionEngine(Stone(), kPi, SteppingMethod::kRungeKutta, 1e-10, limits)
      .Run(feed, Direction::kForward, Derivative::kNone);
  return feed.statuses[0];
}

TEST(SundialsSectionEngine, GivesUpAnOrbitThatDoesNotComeBackInTime) {
  const absl::Status status = StatusUnder({.longest_time = 0.1});
  EXPECT_EQ(status.code(), absl::StatusCode::kOutOfRange);
  EXPECT_NE(status.message().find("no crossing within the longest time"), std::string::npos)
      << status;
}

TEST(SundialsSectionEngine, GivesUpAnOrbitThatTakesTooManySteps) {
  const absl::Status status = StatusUnder({.most_steps = 10});
  EXPECT_EQ(status.code(), absl::StatusCode::kOutOfRange);
  EXPECT_NE(status.message().find("no crossing within 10 steps"), std::string::npos) << status;
}

}  // namespace
}  // namespace celt
