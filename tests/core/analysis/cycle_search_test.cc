#include "core/analysis/cycle_search.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/analysis/cycle_type.h"
#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"
#include "tests/core/analysis/stone_map.h"
#include "tests/core/reference.h"

namespace celt {
namespace {

bool GoOn() { return true; }

CycleSearchState Search(const Map& map, const CycleSearchOptions& options, std::int64_t first,
                        std::int64_t last) {
  auto state = SearchCycles(map, options, first, last, GoOn);
  EXPECT_TRUE(state.ok()) << state.status();
  return *std::move(state);
}

/// x̄ = a x − x³, odd: fixed points 0 and ±√(a − 1), and the cycle of period two ±√(a + 1), which is
/// its own twin.
class Odd final : public Map {
 public:
  explicit Odd(double a) : a_(a) {}
  int dimension() const override { return 1; }
  absl::StatusOr<Image> Apply(const Point& x, Direction, Derivative) const override {
    if (absl::Status status = CheckPoint(x); !status.ok()) return status;
    return Image{.point = Point::Constant(1, a_ * x[0] - x[0] * x[0] * x[0]),
                 .time = 1,
                 .jacobian = SquareMatrix::Constant(1, 1, a_ - 3 * x[0] * x[0])};
  }
  std::vector<Symmetry> Symmetries() const override {
    return {{.apply = [](const Point& x) -> Point { return -x; }, .reverses_time = false}};
  }

 private:
  double a_;
};

CycleSearchOptions OnTheLine(int period) {
  CycleSearchOptions options;
  options.period = period;
  options.lower = Point::Constant(1, -3);
  options.upper = Point::Constant(1, 3);
  return options;
}

TEST(SearchCycles, TwinsAreReportedOnce) {
  const CycleSearchState state = Search(Odd(1.5), OnTheLine(1), 0, 50);
  ASSERT_EQ(state.cycles.size(), 2);
  for (const FoundCycle& found : state.cycles) {
    const double x = found.cycle.points[0][0];
    if (found.twins == 0) {
      EXPECT_NEAR(x, 0, 1e-12);
    } else {
      EXPECT_NEAR(x, -std::sqrt(0.5), 1e-12) << "the lesser of the two";
    }
  }
  EXPECT_EQ(state.cycles[0].hits + state.cycles[1].hits, state.tally.found);
}

TEST(SearchCycles, CycleThatIsItsOwnTwinHasNone) {
  const CycleSearchState state = Search(Odd(1.5), OnTheLine(2), 0, 50);
  ASSERT_EQ(state.cycles.size(), 1);
  EXPECT_EQ(state.cycles[0].twins, 0);
  EXPECT_NEAR(state.cycles[0].cycle.points[0][0], -std::sqrt(2.5), 1e-12);
  EXPECT_NEAR(state.cycles[0].cycle.points[1][0], std::sqrt(2.5), 1e-12);
  EXPECT_GT(state.tally.shorter, 0) << "fixed points are cycles of period two gone round twice";
}

TEST(SearchCycles, TallyAddsUp) {
  const CycleSearchTally tally = Search(Odd(1.5), OnTheLine(2), 0, 80).tally;
  EXPECT_EQ(tally.starts, 80);
  EXPECT_EQ(tally.found + tally.shorter + tally.no_convergence + tally.left_domain +
                tally.singular + tally.outside,
            80);
}

CycleSearchOptions HenonBox(int period) {
  CycleSearchOptions options;
  options.period = period;
  options.lower = Point::Constant(3, -2);
  options.upper = Point::Constant(3, 2);
  return options;
}

TEST(SearchCycles, FindsBothFixedPointsOfTheHenonMap) {
  const auto map = Henon3dSystem().MakeMap({{"m2", 0.85}, {"b", 0.7}}, {});
  const CycleSearchState state = Search(**map, HenonBox(1), 0, 40);
  ASSERT_EQ(state.cycles.size(), 2);
  // 0 and b + m2 − 1.
  const double sum = state.cycles[0].cycle.points[0][0] + state.cycles[1].cycle.points[0][0];
  EXPECT_NEAR(sum, 0.55, 1e-12);
}

TEST(SearchCycles, PiecesMergeToTheWholeToTheLastBit) {
  // Close to the logistic map beyond its largest bounded parameter: three cycles of period 4.
  const auto map = Henon3dSystem().MakeMap({{"m2", 0.05}, {"b", 0.05}, {"m1", 3}}, {});
  const CycleSearchOptions options = HenonBox(4);
  const CycleSearchState whole = Search(**map, options, 0, 100);
  CycleSearchState merged = Search(**map, options, 0, 13);
  Merge(**map, options, Search(**map, options, 13, 57), merged);
  Merge(**map, options, Search(**map, options, 57, 100), merged);
  ASSERT_EQ(whole.cycles.size(), 3);
  ASSERT_EQ(merged.cycles.size(), whole.cycles.size());
  for (std::size_t i = 0; i < whole.cycles.size(); ++i) {
    EXPECT_EQ(merged.cycles[i].first_start, whole.cycles[i].first_start);
    EXPECT_EQ(merged.cycles[i].hits, whole.cycles[i].hits);
    EXPECT_EQ(merged.cycles[i].cycle.points, whole.cycles[i].cycle.points);
  }
  EXPECT_EQ(merged.tally.starts, 100);
  EXPECT_EQ(merged.tally.no_convergence, whole.tally.no_convergence);
}

TEST(DrawStart, DependsOnSeedAndIndexAlone) {
  CycleSearchOptions options = HenonBox(1);
  const Point start = DrawStart(options, 7);
  EXPECT_EQ(DrawStart(options, 7), start);
  EXPECT_NE(DrawStart(options, 8), start);
  options.seed = 2;
  EXPECT_NE(DrawStart(options, 7), start);
  EXPECT_LE(start.cwiseAbs().maxCoeff(), 2);
}

TEST(SearchCycles, BadInputIsNamed) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  EXPECT_EQ(SearchCycles(**map, HenonBox(0), 0, 1, GoOn).status().message(),
            "period: 0 is not allowed; it lies in [1, 256]");
  CycleSearchOptions options = HenonBox(1);
  options.upper[1] = -3;
  EXPECT_EQ(CheckCycleSearch(**map, options).message(),
            "upper: coordinate 2 is -3, below the -2 of lower");
  options = HenonBox(1);
  options.lower = Point::Zero(2);
  EXPECT_EQ(CheckCycleSearch(**map, options).message(), "lower: must be 3 finite numbers");
}

TEST(SearchCycles, TickCancels) {
  EXPECT_EQ(SearchCycles(Odd(1.5), OnTheLine(1), 0, 9, [] { return false; }).status().code(),
            absl::StatusCode::kCancelled);
}

TEST(Symmetries, OfTheStoneCommuteWithItsMapOrReverseIt) {
  const auto map = StoneMap({});
  ASSERT_EQ(map->Symmetries().size(), 3);
  const Point x = Eigen::Vector3d(2.15, -0.66, -0.38);
  const auto there = map->Apply(x, Direction::kForward, Derivative::kNone);
  ASSERT_TRUE(there.ok());
  for (const Symmetry& symmetry : map->Symmetries()) {
    const Direction way = symmetry.reverses_time ? Direction::kBackward : Direction::kForward;
    const auto image = map->Apply(symmetry.apply(x), way, Derivative::kNone);
    ASSERT_TRUE(image.ok());
    // The map's error at its tolerance of 1e-13 a step.
    EXPECT_LT(map->Difference(image->point, symmetry.apply(there->point)).norm(), 1e-10);
  }
}

TEST(Symmetries, OfASectionOffZeroAndPiIsTheHalfTurnAlone) {
  const auto symmetries = StoneMap({{"section_angle", 3}})->Symmetries();
  ASSERT_EQ(symmetries.size(), 1);
  EXPECT_FALSE(symmetries[0].reverses_time);
}

/// The whole section but for its rim.
CycleSearchOptions StoneBox() {
  CycleSearchOptions options;
  options.lower = Eigen::Vector3d(0, -0.95, -0.95);
  options.upper = Eigen::Vector3d(2 * std::numbers::pi, 0.95, 0.95);
  return options;
}

/// At E = 752 there are two fixed points up to twins and mirror images: O* of the reference values,
/// and a saddle-focus.
TEST(SearchCycles, FindsTheStonesFixedPointsTheirTwinsAndMirrors) {
  const auto map = StoneMap({});
  CycleSearchState state = Search(*map, StoneBox(), 0, 24);
  AddMirrors(*map, StoneBox(), state);
  ASSERT_EQ(state.cycles.size(), 4);
  int met = 0;
  for (const FoundCycle& found : state.cycles) {
    EXPECT_EQ(found.twins, 1);
    const Point& x = found.cycle.points[0];
    const std::string type = TypeOf(found.cycle.multipliers).name;
    if (map->Difference(x, ReferenceFixedPoints()[0].point).norm() < 1e-9) {
      EXPECT_EQ(type, "saddle 2-1");
      ++met;
    }
    if (type == "saddle-focus 1-2") {
      EXPECT_LT((x - Eigen::Vector3d(2.1119595086, 0.5418546569, 0.2376559853)).norm(), 1e-9);
      ++met;
    }
  }
  EXPECT_EQ(met, 2);
}

TEST(SearchCycles, MirrorsOfTheStonesCyclesHaveReciprocalMultipliers) {
  const auto map = StoneMap({});
  CycleSearchState state = Search(*map, StoneBox(), 0, 24);
  AddMirrors(*map, StoneBox(), state);
  const std::vector<int> mirrors = MirrorIndices(*map, StoneBox(), state.cycles);
  for (std::size_t i = 0; i < state.cycles.size(); ++i) {
    ASSERT_GE(mirrors[i], 0);
    EXPECT_EQ(mirrors[mirrors[i]], i);
    const auto& mine = state.cycles[i].cycle.multipliers;
    const auto& theirs = state.cycles[mirrors[i]].cycle.multipliers;
    for (int k = 0; k < 3; ++k) {
      // Of a pair the order is upside down, and so is that of the moduli.
      const double modulus = std::abs(mine[k]) * std::abs(theirs[2 - k]);
      EXPECT_NEAR(modulus, 1, 1e-9);
    }
  }
}

}  // namespace
}  // namespace celt
