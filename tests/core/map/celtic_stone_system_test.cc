#include "core/map/celtic_stone_system.h"

#include <cmath>
#include <string>

#include "gtest/gtest.h"

namespace celt {
namespace {

std::string Refusal(const Parameters& parameters, const Numerics& numerics = {}) {
  const auto map = CelticStoneSystem().MakeMap(parameters, numerics);
  EXPECT_EQ(map.status().code(), absl::StatusCode::kInvalidArgument);
  return std::string(map.status().message());
}

TEST(CelticStoneSystem, RefusesStonesThatCannotBe) {
  EXPECT_TRUE(Refusal({{"mass", -1}}).starts_with("mass: -1 is not allowed"));
  EXPECT_TRUE(Refusal({{"energy", std::nan("")}}).starts_with("energy: nan is not allowed"));
  EXPECT_TRUE(Refusal({{"inertia_3", 9}}).starts_with("inertia_3: 9 is not allowed"));
}

TEST(CelticStoneSystem, StartsWhereTheMapIsDefined) {
  const auto map = CelticStoneSystem().MakeMap({}, {.tolerance = 1e-6});
  ASSERT_TRUE(map.ok()) << map.status();
  for (const int sign : {-1, 0, 1}) {
    const Point start =
        CelticStoneSystem().DefaultStart() + sign * CelticStoneSystem().StartSpread();
    EXPECT_TRUE((*map)->Apply(start, Direction::kForward, Derivative::kNone).ok());
  }
}

TEST(CelticStoneSystem, SaysAtAStartThatItsLevelIsEmpty) {
  const auto map = CelticStoneSystem().MakeMap({{"energy", 50}}, {});
  ASSERT_TRUE(map.ok()) << map.status();
  const auto image =
      (*map)->Apply(CelticStoneSystem().DefaultStart(), Direction::kForward, Derivative::kNone);
  EXPECT_EQ(image.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(image.status().message().find("energy: 50 is not allowed at"), 0u) << image.status();
}

TEST(CelticStoneSystem, DependsOnEachOfItsParameters) {
  const Numerics numerics{.tolerance = 1e-8};
  const Point start = CelticStoneSystem().DefaultStart();
  const auto map = CelticStoneSystem().MakeMap({}, numerics);
  const Point image = (*map)->Apply(start, Direction::kForward, Derivative::kNone)->point;
  for (const ParameterInfo& info : CelticStoneSystem().parameters()) {
    if (info.name == "crossing") continue;  // has two values only
    const Parameters changed = {{std::string(info.name), 0.99 * info.default_value}};
    const auto other = CelticStoneSystem().MakeMap(changed, numerics);
    ASSERT_TRUE(other.ok()) << other.status();
    const auto moved = (*other)->Apply(start, Direction::kForward, Derivative::kNone);
    ASSERT_TRUE(moved.ok()) << moved.status();
    EXPECT_GT((moved->point - image).norm(), 1e-5) << info.name;
  }
}

TEST(CelticStoneSystem, CrossesItsSectionEitherWay) {
  // At this point orbits come back both ways, the next time and the time after.
  const Point start = Eigen::Vector3d(0.4, -0.8, -0.6);
  const auto image = [&](double crossing) {
    const auto map =
        CelticStoneSystem().MakeMap({{"section_angle", 2.5}, {"crossing", crossing}}, {});
    return (*map)->Apply(start, Direction::kForward, Derivative::kNone);
  };
  ASSERT_TRUE(image(1).ok()) << image(1).status();
  ASSERT_TRUE(image(-1).ok()) << image(-1).status();
  EXPECT_GT((image(1)->point - image(-1)->point).norm(), 1e-3);
}

TEST(CelticStoneSystem, RefusesACrossingThatIsNeitherWay) {
  const auto map = CelticStoneSystem().MakeMap({{"crossing", 0.5}}, {});
  EXPECT_EQ(map.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_NE(map.status().message().find("crossing: 0.5 is not allowed; it is 1"), std::string::npos)
      << map.status();
}

}  // namespace
}  // namespace celt
