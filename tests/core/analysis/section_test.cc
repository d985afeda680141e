#include "core/analysis/section.h"

#include <vector>

#include "core/map/celtic_stone_system.h"
#include "core/map/henon3d_system.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

bool Ignore(const SectionRecord&) { return true; }

std::vector<SectionRecord> Iterate(const Map& map, SectionOrbit& orbit, std::int64_t iterates,
                                   Direction direction) {
  std::vector<SectionRecord> records;
  const absl::Status status =
      AdvanceSection(map, orbit, iterates, direction, [&](const SectionRecord& record) {
        records.push_back(record);
        return true;
      });
  EXPECT_TRUE(status.ok()) << status;
  return records;
}

TEST(Section, ChunksChangeNothing) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  SectionOrbit whole = {.point = Henon3dSystem().DefaultStart()};
  SectionOrbit cut = whole;
  const auto records = Iterate(**map, whole, 100, Direction::kForward);
  Iterate(**map, cut, 37, Direction::kForward);
  const auto rest = Iterate(**map, cut, 63, Direction::kForward);
  ASSERT_EQ(records.size(), 100U);
  EXPECT_EQ(rest.back().at.point, records.back().at.point);
  EXPECT_EQ(rest.back().at.iterate, 100);
  EXPECT_EQ(cut.time, whole.time);
}

TEST(Section, OfTheStoneGoesBackTheWayItCame) {
  const auto map = CelticStoneSystem().MakeMap({}, {});
  const Point start = CelticStoneSystem().DefaultStart() + Point(Eigen::Vector3d(1e-3, 1e-3, 1e-3));
  SectionOrbit orbit = {.point = start};
  const auto forward = Iterate(**map, orbit, 3, Direction::kForward);
  EXPECT_EQ(forward[1].at.iterate, 2);
  EXPECT_EQ(forward[2].at.time,
            forward[0].return_time + forward[1].return_time + forward[2].return_time);
  EXPECT_NEAR(forward[0].return_time, 0.79, 0.01);
  const auto backward = Iterate(**map, orbit, 3, Direction::kBackward);
  EXPECT_GT(backward[0].return_time, 0);
  EXPECT_EQ(orbit.iterate, 0);
  // Error of some 1e-11 an iterate, times what three iterates of the inverse stretch, 1/0.66 each.
  EXPECT_NEAR(orbit.time, 0, 1e-9);
  EXPECT_LT((*map)->Difference(orbit.point, start).norm(), 1e-9);
}

TEST(Section, KeepsWhatCameBeforeTheOrbitWasLost) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  SectionOrbit orbit = {.point = Eigen::Vector3d(5, 5, 5)};
  int visited = 0;
  const absl::Status status =
      AdvanceSection(**map, orbit, 1000, Direction::kForward, [&](const SectionRecord& record) {
        ++visited;
        return record.at.point.allFinite();
      });
  EXPECT_EQ(status.code(), absl::StatusCode::kOutOfRange);
  EXPECT_GT(visited, 0);
  EXPECT_EQ(orbit.iterate, visited);
}

TEST(Section, VisitStopsTheOrbit) {
  const auto map = Henon3dSystem().MakeMap({}, {});
  SectionOrbit orbit = {.point = Henon3dSystem().DefaultStart()};
  const absl::Status status =
      AdvanceSection(**map, orbit, 1000, Direction::kForward,
                     [](const SectionRecord& record) { return record.at.iterate < 10; });
  EXPECT_EQ(status.code(), absl::StatusCode::kCancelled);
  EXPECT_EQ(orbit.iterate, 10);
}

TEST(Section, StartOutsideTheDomainIsTheMapsInvalidArgument) {
  const auto map = CelticStoneSystem().MakeMap({}, {});
  SectionOrbit orbit = {.point = Eigen::Vector3d(0, 2, 0)};
  EXPECT_EQ(AdvanceSection(**map, orbit, 1, Direction::kForward, Ignore).code(),
            absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace celt
