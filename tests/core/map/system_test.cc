#include "core/map/system.h"

#include <cmath>
#include <limits>
#include <string>

#include "gtest/gtest.h"

namespace celt {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string MessageOf(const absl::Status& status) {
  EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
  return std::string(status.message());
}

bool Mentions(const std::string& message, const std::string& word) {
  return message.find(word) != std::string::npos;
}

TEST(System, EachMakesItsMapAndStartsInTheDomain) {
  for (const System* system : AllSystems()) {
    const auto map = system->MakeMap({}, {});
    ASSERT_TRUE(map.ok()) << system->name() << ": " << map.status();
    EXPECT_EQ((*map)->dimension(), static_cast<int>(system->coordinates().size()));
    EXPECT_TRUE((*map)->CheckPoint(system->DefaultStart()).ok()) << system->name();
    EXPECT_TRUE(
        (*map)->Apply(system->DefaultStart(), Direction::kForward, Derivative::kJacobian).ok());
    EXPECT_EQ(system->StartSpread().size(), (*map)->dimension());
  }
}

TEST(System, DefaultsLieInTheirRanges) {
  for (const System* system : AllSystems()) {
    Parameters defaults;
    for (const ParameterInfo& info : system->parameters())
      defaults.emplace(info.name, info.default_value);
    const auto resolved = system->Resolve(defaults);
    ASSERT_TRUE(resolved.ok()) << resolved.status();
    EXPECT_EQ(*resolved, *system->Resolve({}));
  }
}

TEST(System, UnknownParameterIsNamedWithTheKnownOnes) {
  const std::string message = MessageOf((*FindSystem("lorenz"))->Resolve({{"roh", 28}}).status());
  EXPECT_TRUE(Mentions(message, "roh")) << message;
  EXPECT_TRUE(Mentions(message, "rho")) << message;
}

TEST(System, ValueOutOfRangeIsNamedWithTheRange) {
  const System& lorenz = **FindSystem("lorenz");
  EXPECT_EQ(MessageOf(lorenz.Resolve({{"step", 0}}).status()),
            "step: 0 is not allowed; it lies in (0, 100]");
  EXPECT_EQ(MessageOf(lorenz.Resolve({{"step", kNan}}).status()),
            "step: nan is not allowed; it lies in (0, 100]");
  EXPECT_EQ(MessageOf(lorenz.Resolve({{"rho", kNan}}).status()),
            "rho: nan is not allowed; it lies in (-inf, inf)");
}

TEST(System, UnknownNameListsTheKnownOnes) {
  const std::string message = MessageOf(FindSystem("rattleback").status());
  EXPECT_TRUE(Mentions(message, "rattleback")) << message;
  EXPECT_TRUE(Mentions(message, "celtic-stone")) << message;
}

TEST(System, ToleranceHasARange) {
  EXPECT_TRUE(CheckNumerics({.tolerance = 1e-14}).ok());
  for (const double tolerance : {0.0, -1e-9, 1e-15, 0.1, kNan}) {
    const std::string message = MessageOf(CheckNumerics({.tolerance = tolerance}));
    EXPECT_TRUE(Mentions(message, "tolerance")) << message;
  }
}

TEST(System, PointIsCheckedByCoordinate) {
  const System& henon = **FindSystem("henon3d");
  EXPECT_TRUE(CheckPoint(henon, Eigen::Vector3d(1, 2, 3)).ok());
  EXPECT_TRUE(Mentions(MessageOf(CheckPoint(henon, Eigen::Vector2d(1, 2))), "x, y, z"));
  EXPECT_EQ(MessageOf(CheckPoint(henon, Eigen::Vector3d(1, kNan, 3))),
            "y: nan is not a finite number");
}

}  // namespace
}  // namespace celt
