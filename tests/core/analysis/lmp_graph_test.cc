#include "core/analysis/lmp_graph.h"

#include <cmath>
#include <numbers>

#include "core/analysis/line_angle.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

/// A cloud in the unit cube whose direction turns with the first coordinate, by one radian from
/// side to side.
std::vector<LmpPoint> Cloud(int count) {
  std::vector<LmpPoint> points;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d x(std::fmod(i * std::numbers::sqrt2, 1), std::fmod(i * 0.73205080756, 1),
                            std::fmod(i * 0.2360679775, 1));
    points.push_back({i, x, Eigen::Vector3d(std::cos(x[0]), std::sin(x[0]), 0)});
  }
  return points;
}

TEST(LmpGraph, FindsEveryClosePairOnce) {
  const std::vector<LmpPoint> points = Cloud(1000);
  const std::vector<LmpBin> bins = LmpGraph(points, {.most_near_pairs = 50'000});
  std::int64_t complete = 0;
  for (const LmpBin& bin : bins) {
    std::int64_t pairs = 0;
    double widest = 0;
    for (int i = 0; i < 1000; ++i) {
      for (int j = 0; j < i; ++j) {
        const double distance = (points[i].x - points[j].x).norm();
        if (distance < bin.from || distance >= bin.to) continue;
        ++pairs;
        widest = std::max(widest, AngleOfLines(points[i].e, points[j].e));
      }
    }
    if (!bin.complete) continue;
    complete += pairs;
    EXPECT_EQ(bin.pairs, pairs) << "distances from " << bin.from << " to " << bin.to;
    if (pairs > 0) {
      EXPECT_EQ(bin.widest.angle, widest);
    }
  }
  EXPECT_GT(complete, 1000);
}

TEST(LmpGraph, ContinuousFieldHasItsModulusOfContinuityAsEnvelope) {
  for (const LmpBin& bin : LmpGraph(Cloud(3000))) {
    // The field turns by |Δx| ≤ ρ.
    if (bin.pairs > 0) {
      EXPECT_LE(bin.widest.angle, bin.to * (1 + 1e-12));
    }
  }
}

TEST(LmpGraph, OneFoldShowsAsAWidePairAtSmallDistance) {
  std::vector<LmpPoint> points = Cloud(3000);
  points.push_back({3000, points[17].x + Point(Eigen::Vector3d(0, 1e-4, 0)),
                    Eigen::Vector3d(-std::sin(points[17].x[0]), std::cos(points[17].x[0]), 0)});
  const LmpNear near = NearestPairs(LmpGraph(points), 1e-3);
  EXPECT_NEAR(near.widest.angle, std::numbers::pi / 2, 1e-7);
  EXPECT_EQ(near.widest.first, 17);
  EXPECT_EQ(near.widest.second, 3000);
}

TEST(LmpGraph, SignsOfDirectionsMeanNothing) {
  std::vector<LmpPoint> points = Cloud(500);
  const double before = NearestPairs(LmpGraph(points), 0.1).widest.angle;
  for (std::size_t i = 0; i < points.size(); i += 3) points[i].e *= -1;
  EXPECT_EQ(NearestPairs(LmpGraph(points), 0.1).widest.angle, before);
}

TEST(LmpGraph, ThinsOutPointsThatAreAllTheSame) {
  std::vector<LmpPoint> points(4000, {0, Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(1, 0, 0)});
  const std::vector<LmpBin> bins = LmpGraph(points, {.most_near_pairs = 10'000});
  EXPECT_GT(bins[0].pairs, 1000);
  EXPECT_LE(bins[0].pairs, 10'000);
  EXPECT_EQ(bins[0].widest.angle, 0);
}

TEST(LmpGraph, KeepsABoundedSampleOfEachBin) {
  bool full = false;
  for (const LmpBin& bin : LmpGraph(Cloud(1000), {.sample = 5})) {
    EXPECT_EQ(std::ssize(bin.sample), std::min<std::int64_t>(5, bin.pairs));
    for (const LmpPair& pair : bin.sample) {
      full = true;
      EXPECT_LT(pair.first, pair.second);
      EXPECT_GE(pair.distance, bin.from);
      EXPECT_LT(pair.distance, bin.to);
    }
  }
  EXPECT_TRUE(full);
}

TEST(LmpGraph, OfNoPointsIsEmpty) {
  for (const LmpBin& bin : LmpGraph({})) EXPECT_EQ(bin.pairs, 0);
}

}  // namespace
}  // namespace celt
