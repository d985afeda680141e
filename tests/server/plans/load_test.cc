#include "server/plans/load.h"

#include <string>

#include "google/protobuf/text_format.h"
#include "gtest/gtest.h"
#include "server/plans/factory.h"
#include "server/plans/serialize.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

jobs::Load Load(const std::string& text) {
  v1::JobSpec spec;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &spec)) << text;
  const auto resolved = ResolveSpec(spec);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  const std::string bytes = Serialize(*resolved);
  const auto plan = MakePlan(bytes);
  EXPECT_TRUE(plan.ok()) << plan.status();
  return LoadOf(bytes, **plan);
}

TEST(Load, CountsEveryIterateWhereTheSpecificationTells) {
  const jobs::Load spectrum = Load("lyapunov { iterates: 1000 orbits: 16 transient: 10 }");
  EXPECT_EQ(spectrum.iterates, 1160);
  EXPECT_EQ(spectrum.effort, 1160);
  EXPECT_EQ(spectrum.kind, "lyapunov/celtic-stone/fast");
  EXPECT_EQ(spectrum.threads, 2) << "eight orbits go together";
  EXPECT_EQ(Load("section { iterates: 50 transient: 20 }").iterates, 70);
  EXPECT_EQ(Load("hyperbolicity { iterates: 2000 transient: 20 scout: 3000 }").iterates, 5020);
}

TEST(Load, OfASweepIsThatOfItsNodes) {
  const jobs::Load sweep = Load(
      "system { name: 'henon3d' } sweep { axes { parameter: 'm1' from: 0 to: 0.1 nodes: 10 } "
      "lyapunov { iterates: 90 orbits: 1 transient: 10 } }");
  EXPECT_EQ(sweep.kind, "sweep/lyapunov/henon3d");
  EXPECT_EQ(sweep.iterates, 1000);
  EXPECT_EQ(sweep.effort, 1000);
  EXPECT_EQ(sweep.most_units, 1);
}

TEST(Load, TellsNoNumbersThatNobodyKnows) {
  const jobs::Load branch = Load("continuation { parameter: 'energy' to: 751 }");
  EXPECT_EQ(branch.iterates, 0);
  EXPECT_EQ(branch.most_units, 0);
  EXPECT_EQ(branch.effort, 100) << "percent";
  EXPECT_GT(branch.seconds, 0);
}

TEST(Load, SlowEnginesAreAKindOfTheirOwn) {
  const jobs::Load slow = Load("numerics { engine: ENGINE_CVODE } lyapunov {}");
  EXPECT_EQ(slow.kind, "lyapunov/celtic-stone/cvode");
  EXPECT_GT(slow.seconds, Load("lyapunov {}").seconds);
}

}  // namespace
}  // namespace celt::plans
