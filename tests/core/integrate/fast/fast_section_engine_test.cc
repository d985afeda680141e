#include "core/integrate/fast/fast_section_engine.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <numbers>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/integrate/fast/two_step.h"
#include "core/integrate/section_event.h"
#include "core/integrate/sundials_section_engine.h"
#include "core/model/andoyer.h"
#include "gtest/gtest.h"
#include "tests/core/integrate/list_feed.h"
#include "tests/core/reference.h"

namespace celt {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kEnergy = 752;

CelticStone Stone() { return CelticStone{StoneParameters{}}; }

CrossingTask TaskAt(const CelticStone& stone, double energy, double angle, const SectionPoint& x) {
  const auto lifted = LiftToLevel(stone, energy, angle, x);
  EXPECT_TRUE(lifted.ok()) << lifted.status();
  return {.state = lifted->state, .tangents = lifted->derivative};
}

std::vector<CrossingTask> ReferenceTasks() {
  std::vector<CrossingTask> tasks;
  for (const ReferenceIterate& iterate : ReferenceIterates()) {
    tasks.push_back(TaskAt(Stone(), kEnergy, kPi, iterate.point));
  }
  return tasks;
}

std::vector<Crossing> Cross(const SectionEngine& engine, const std::vector<CrossingTask>& tasks,
                            Direction direction = Direction::kForward,
                            Derivative derivative = Derivative::kJacobian) {
  ListFeed feed(tasks);
  engine.Run(feed, direction, derivative);
  for (const absl::Status& status : feed.statuses) EXPECT_TRUE(status.ok()) << status;
  return feed.crossings;
}

/// Tolerances by which steps do without the step before, and make use of it.
constexpr double kLoose = 1e-10;
constexpr double kTight = 1e-11;

std::vector<Crossing> RunInLanes(int lanes, double tolerance,
                                 const std::vector<CrossingTask>& tasks,
                                 Derivative derivative = Derivative::kJacobian) {
  return Cross(FastSectionEngine(Stone(), kPi, tolerance, {.lanes = lanes}), tasks,
               Direction::kForward, derivative);
}

/// Equal to the last bit, signs of zeros included.
void ExpectSameBits(const Crossing& a, const Crossing& b, bool tangents = true) {
  EXPECT_EQ(std::memcmp(a.state.data(), b.state.data(), sizeof(a.state)), 0);
  EXPECT_EQ(std::memcmp(a.velocity.data(), b.velocity.data(), sizeof(a.velocity)), 0);
  EXPECT_EQ(a.time, b.time);
  if (tangents) {
    EXPECT_EQ(std::memcmp(a.tangents.data(), b.tangents.data(), sizeof(a.tangents)), 0);
  }
}

/// The section map's derivative: tangents projected along the flow onto the section, in its
/// coordinates.
Eigen::Matrix3d Jacobian(const Crossing& crossing, double angle = kPi) {
  const StoneState normal = SectionEvent(angle).Gradient(crossing.state);
  const StoneTangents onto = crossing.tangents - crossing.velocity *
                                                     (normal.transpose() * crossing.tangents) /
                                                     normal.dot(crossing.velocity);
  return ProjectToSection(crossing.state).derivative * onto;
}

/// Largest errors over the quadruple-precision reference.
struct Errors {
  double map = 0;
  double jacobian = 0;  ///< relative to the largest entry
  double time = 0;
};

Errors ErrorsAt(double tolerance) {
  const std::vector<Crossing> crossings =
      Cross(FastSectionEngine(Stone(), kPi, tolerance), ReferenceTasks());
  const std::vector<ReferenceIterate> reference = ReferenceIterates();
  Errors errors;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const SectionPoint x = ProjectToSection(crossings[i].state).x;
    const Eigen::Matrix3d difference = Jacobian(crossings[i]) - reference[i].jacobian;
    errors.map = std::max(errors.map, (x - reference[i].image).cwiseAbs().maxCoeff());
    errors.jacobian = std::max(errors.jacobian, difference.cwiseAbs().maxCoeff() /
                                                    reference[i].jacobian.cwiseAbs().maxCoeff());
    errors.time = std::max(errors.time, std::abs(crossings[i].time - reference[i].time));
  }
  return errors;
}

TEST(FastSectionEngine, ErrsByAFewTolerancesOverTheAttractor) {
  // What the header promises: 5 tolerances for the map, 30 for the Jacobian. The reference is good
  // to 1e-15 and 1e-13, and 40 steps round the state to some 1e-14.
  for (const double tolerance : {1e-11, 1e-12, 1e-13}) {
    const Errors errors = ErrorsAt(tolerance);
    EXPECT_LT(errors.map, 5 * tolerance + 1e-14) << tolerance;
    EXPECT_LT(errors.time, 5 * tolerance + 1e-14) << tolerance;
    EXPECT_LT(errors.jacobian, 30 * tolerance + 1e-12) << tolerance;
  }
}

TEST(FastSectionEngine, ConvergesWithTheNinthOrder) {
  // Steps go with the ninth root of the tolerance. Between the two of a pair, steps are of one
  // kind, errors above rounding and steps short enough for the leading term to show.
  const std::pair<double, double> pairs[] = {{1e-9, kLoose}, {kTight, 1e-12}};
  for (const auto& [coarse, fine] : pairs) {
    const Errors more = ErrorsAt(coarse);
    const Errors less = ErrorsAt(fine);
    const double steps = std::pow(coarse / fine, 1 / 9.0);
    EXPECT_GT(std::log(more.map / less.map) / std::log(steps), 8.5) << coarse;
    EXPECT_GT(std::log(more.jacobian / less.jacobian) / std::log(steps), 8.5) << coarse;
  }
}

class LaneCounts : public testing::TestWithParam<std::tuple<int, double>> {
 protected:
  int lanes() const { return std::get<0>(GetParam()); }
  double tolerance() const { return std::get<1>(GetParam()); }
};

TEST_P(LaneCounts, GiveTheSameBits) {
  const std::vector<CrossingTask> tasks = ReferenceTasks();
  const std::vector<Crossing> best = RunInLanes(0, tolerance(), tasks);
  const std::vector<Crossing> some = RunInLanes(lanes(), tolerance(), tasks);
  for (std::size_t i = 0; i < tasks.size(); ++i) ExpectSameBits(best[i], some[i]);
}

TEST_P(LaneCounts, GiveTheSameBitsInAnyOrder) {
  const std::vector<CrossingTask> tasks = ReferenceTasks();
  const std::vector<Crossing> in_order = RunInLanes(lanes(), tolerance(), tasks);
  // 77 is prime to 200: a permutation that changes every orbit's lane, neighbours and the time it
  // joins them.
  std::vector<CrossingTask> shuffled;
  for (std::size_t i = 0; i < tasks.size(); ++i) shuffled.push_back(tasks[i * 77 % tasks.size()]);
  const std::vector<Crossing> out_of_order = RunInLanes(lanes(), tolerance(), shuffled);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    ExpectSameBits(in_order[i * 77 % tasks.size()], out_of_order[i]);
  }
}

TEST_P(LaneCounts, GiveTheSameOrbitWithTangentsAndWithout) {
  const std::vector<CrossingTask> tasks = ReferenceTasks();
  const std::vector<Crossing> with = RunInLanes(lanes(), tolerance(), tasks);
  const std::vector<Crossing> without = RunInLanes(lanes(), tolerance(), tasks, Derivative::kNone);
  for (std::size_t i = 0; i < tasks.size(); ++i) ExpectSameBits(with[i], without[i], false);
}

TEST_P(LaneCounts, DoNotNoticeANeighbourThatIsLost) {
  std::vector<CrossingTask> tasks = ReferenceTasks();
  const std::vector<Crossing> alone = RunInLanes(lanes(), tolerance(), tasks);
  // The stone hangs below its contact point and rolls up the paraboloid for ever: γ₃ → 0.
  const CrossingTask lost = TaskAt(Stone(), kEnergy, kPi, {1, 0.9, -0.9});
  for (const std::size_t at : {50, 3, 0}) {
    tasks.insert(tasks.begin() + static_cast<std::ptrdiff_t>(at), lost);
  }
  ListFeed feed(tasks);
  FastSectionEngine(Stone(), kPi, tolerance(), {.lanes = lanes()})
      .Run(feed, Direction::kForward, Derivative::kJacobian);
  std::size_t good = 0;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (tasks[i].state == lost.state) {
      EXPECT_EQ(feed.statuses[i].code(), absl::StatusCode::kOutOfRange);
      const std::string message(feed.statuses[i].message());
      EXPECT_TRUE(message.starts_with("orbit lost at t = 3.")) << message;
      EXPECT_NE(message.find("gamma3 goes to 0"), std::string::npos) << message;
    } else {
      ASSERT_TRUE(feed.statuses[i].ok()) << feed.statuses[i];
      ExpectSameBits(feed.crossings[i], alone[good++]);
    }
  }
  EXPECT_EQ(good, alone.size());
}

INSTANTIATE_TEST_SUITE_P(All, LaneCounts,
                         testing::Combine(testing::Values(1, 4, 8, 16),
                                          testing::Values(kLoose, kTight)));

TEST(FastSectionEngine, IsTestedWithAndWithoutTheStepBefore) {
  // The step is 4.2 tolerance^(1/9), as the engine's header has it.
  EXPECT_GT(4.2 * std::pow(kLoose, 1 / 9.0), fast::kLongestTwoStep);
  EXPECT_LT(4.2 * std::pow(kTight, 1 / 9.0), fast::kLongestTwoStep);
}

/// Makes the next task of an orbit ready only when the one before is done, as a map's iterates are.
class ChainFeed final : public CrossingFeed {
 public:
  ChainFeed(std::vector<CrossingTask> starts, int length)
      : tasks(std::move(starts)), left_(tasks.size(), length) {
    for (std::size_t i = 0; i < tasks.size(); ++i) ready_.push_back(static_cast<int>(i));
  }
  bool Next(CrossingTask& task, int& ticket) override {
    if (ready_.empty()) return false;
    ticket = ready_.front();
    ready_.erase(ready_.begin());
    task = tasks[ticket];
    return true;
  }
  void Done(int ticket, const absl::Status& status, const Crossing& crossing) override {
    EXPECT_TRUE(status.ok()) << status;
    tasks[ticket].state = crossing.state;
    if (--left_[ticket] > 0) ready_.push_back(ticket);
  }

  std::vector<CrossingTask> tasks;

 private:
  std::vector<int> left_;
  std::vector<int> ready_;
};

TEST(FastSectionEngine, CarriesChainsHoweverManyAreLeft) {
  const std::vector<CrossingTask> starts = ReferenceTasks();
  const FastSectionEngine engine(Stone(), kPi, kTight);
  ChainFeed together({starts.begin(), starts.begin() + 11}, 7);
  engine.Run(together, Direction::kForward, Derivative::kNone);
  for (std::size_t i = 0; i < together.tasks.size(); ++i) {
    ChainFeed alone({starts[i]}, 7);
    engine.Run(alone, Direction::kForward, Derivative::kNone);
    EXPECT_EQ(alone.tasks[0].state, together.tasks[i].state);
  }
}

/// Counts how many tasks are under way.
class CountingFeed final : public CrossingFeed {
 public:
  explicit CountingFeed(CrossingFeed& feed) : feed_(feed) {}
  bool Next(CrossingTask& task, int& ticket) override {
    if (!feed_.Next(task, ticket)) return false;
    most = std::max(most, ++under_way_);
    return true;
  }
  void Done(int ticket, const absl::Status& status, const Crossing& crossing) override {
    --under_way_;
    feed_.Done(ticket, status, crossing);
  }

  int most = 0;

 private:
  CrossingFeed& feed_;
  int under_way_ = 0;
};

TEST_P(LaneCounts, TakeNoMoreTasksThanTwiceTheirNumber) {
  ListFeed feed(ReferenceTasks());
  CountingFeed counting(feed);
  FastSectionEngine(Stone(), kPi, tolerance(), {.lanes = lanes()})
      .Run(counting, Direction::kForward, Derivative::kJacobian);
  // And two to see whether there is one task or several.
  EXPECT_LE(counting.most, 2 * lanes() + 2);
  EXPECT_GE(counting.most, lanes());
}

/// Half a turn of the stone about its vertical axis.
template <class Columns>
Columns HalfTurned(Columns columns) {
  for (const int row : {0, 1, 3, 4}) columns.row(row) *= -1;
  return columns;
}

TEST(FastSectionEngine, TakesTwinsToTwins) {
  std::vector<CrossingTask> tasks = ReferenceTasks();
  const std::vector<Crossing> crossings = RunInLanes(0, kTight, tasks);
  for (CrossingTask& task : tasks) task = {HalfTurned(task.state), HalfTurned(task.tangents)};
  const std::vector<Crossing> twins = RunInLanes(0, kTight, tasks);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    // Changes of sign round nothing, but sums of three may be taken in another order.
    EXPECT_LT((twins[i].state - HalfTurned(crossings[i].state)).norm(),
              1e-13 * crossings[i].state.norm());
    EXPECT_LT((twins[i].tangents - HalfTurned(crossings[i].tangents)).norm(),
              1e-11 * crossings[i].tangents.norm());
  }
}

/// A stone, a section and an energy.
struct Case {
  const char* name;
  StoneParameters stone;
  double angle;
  double energy;
};

/// Anything but the default: mass, gravity and sizes; sections where the second half of e counts.
std::vector<Case> Cases() {
  const StoneParameters heavy{.inertia1 = 11,
                              .inertia2 = 14,
                              .inertia3 = 20,
                              .mass = 3,
                              .gravity = 9.8,
                              .radius1 = 5,
                              .radius2 = 3,
                              .height = 0.7,
                              .delta = -0.3};
  return {{"quarter turn", {}, 0.5 * kPi, 752},
          {"oblique", {}, 2.2, 800},
          {"negative angle", {}, -2.5, 752},
          {"heavy stone", heavy, kPi, 160},
          {"heavy stone, oblique", heavy, 3.9, 200}};
}

/// Points of a grid that lie in the level, on either side of γ₃ = 0.
std::vector<CrossingTask> TasksOnGrid(const Case& c) {
  std::vector<CrossingTask> tasks;
  for (const double l : {0.4, 2.1, 5.0}) {
    for (const double l_over_g : {-0.8, -0.2, 0.5}) {
      for (const double h_over_g : {-0.6, 0.3, 0.9}) {
        const auto lifted =
            LiftToLevel(CelticStone(c.stone), c.energy, c.angle, {l, l_over_g, h_over_g});
        if (lifted.ok()) tasks.push_back({.state = lifted->state, .tangents = lifted->derivative});
      }
    }
  }
  return tasks;
}

TEST(FastSectionEngine, AgreesWithSundialsOnOtherStonesAndSections) {
  // Orbits that take longer are lost to both, but cost SUNDIALS much time.
  const CrossingLimits limits{.longest_time = 2, .most_steps = 3000};
  int above = 0;
  int below = 0;
  for (const Case& c : Cases()) {
    const CelticStone stone(c.stone);
    const std::vector<CrossingTask> tasks = TasksOnGrid(c);
    for (const Direction direction : {Direction::kForward, Direction::kBackward}) {
      ListFeed ours(tasks);
      ListFeed theirs(tasks);
      FastSectionEngine(stone, c.angle, 1e-12, {.limits = limits})
          .Run(ours, direction, Derivative::kJacobian);
      SundialsSectionEngine(stone, c.angle, SteppingMethod::kRungeKutta, 1e-12, limits)
          .Run(theirs, direction, Derivative::kJacobian);
      for (std::size_t i = 0; i < tasks.size(); ++i) {
        SCOPED_TRACE(testing::Message() << c.name << ", task " << i);
        ASSERT_EQ(ours.statuses[i].code(), theirs.statuses[i].code()) << ours.statuses[i] << "\n"
                                                                      << theirs.statuses[i];
        if (!ours.statuses[i].ok()) continue;
        ++(tasks[i].state[5] > 0 ? above : below);
        const Crossing& a = ours.crossings[i];
        const Crossing& b = theirs.crossings[i];
        // Tolerances add up over some hundred steps, and orbits stretch by up to a thousand.
        EXPECT_LT((a.state - b.state).norm(), 1e-8 * b.state.norm());
        // ω follows from M by a matrix with a condition of up to 10⁴: so many roundings.
        EXPECT_LT((a.velocity - stone.Field(a.state)).norm(), 1e4 * 1.1e-15 * b.velocity.norm());
        EXPECT_NEAR(a.time, b.time, 1e-8 * b.time);
        EXPECT_LT((a.tangents - b.tangents).norm(), 1e-7 * b.tangents.norm());
      }
    }
  }
  EXPECT_GT(above, 20);
  EXPECT_GT(below, 0) << "orbits of the stone below its contact point";
}

TEST(FastSectionEngine, SeesTwoCrossingsOfEInOneStep) {
  // Backward from here the orbit passes |L/G| = 1 so closely at t = 5.93 that g turns by half a
  // turn within 0.01, and e changes its sign twice; the later crossing is at t = 6.74.
  const CrossingTask task = TaskAt(Stone(), kEnergy, 0.5 * kPi, {2.1, 0.5, 0.9});
  for (const double tolerance : {1e-8, 1e-9, 1e-10, 1e-11, 1e-12}) {
    const auto crossings = Cross(FastSectionEngine(Stone(), 0.5 * kPi, tolerance), {task},
                                 Direction::kBackward, Derivative::kNone);
    EXPECT_NEAR(crossings[0].time, 5.931269940386, 1e3 * tolerance) << tolerance;
  }
}

absl::Status StatusUnder(const CrossingLimits& limits) {
  ListFeed feed({ReferenceTasks()[0]});
  FastSectionEngine(Stone(), kPi, 1e-10, {.limits = limits})
      .Run(feed, Direction::kForward, Derivative::kNone);
  return feed.statuses[0];
}

TEST(FastSectionEngine, GivesUpAnOrbitThatDoesNotComeBackInTime) {
  const absl::Status status = StatusUnder({.longest_time = 0.1});
  EXPECT_EQ(status.code(), absl::StatusCode::kOutOfRange);
  EXPECT_NE(status.message().find("no crossing within the longest time"), std::string::npos)
      << status;
}

TEST(FastSectionEngine, GivesUpAnOrbitThatTakesTooManySteps) {
  const absl::Status status = StatusUnder({.most_steps = 10});
  EXPECT_EQ(status.code(), absl::StatusCode::kOutOfRange);
  EXPECT_NE(status.message().find("no crossing within 10 steps"), std::string::npos) << status;
}

}  // namespace
}  // namespace celt
