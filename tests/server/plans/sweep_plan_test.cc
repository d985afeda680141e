#include "server/plans/sweep_plan.h"

#include <cmath>
#include <string>
#include <vector>

#include "gtest/gtest.h"
#include "plans/plan_testing.h"
#include "server/plans/run_plan.h"
#include "server/plans/sweep_grid.h"

namespace celt::plans {
namespace {

constexpr char kHenonSweep[] =
    "system { name: 'henon3d' } sweep { "
    "  axes { parameter: 'm2' from: 0.81 to: 0.85 nodes: 5 } "
    "  axes { parameter: 'm1' from: 0 to: 0.01 nodes: 2 } "
    "  lyapunov { iterates: 400 orbits: 2 transient: 100 } }";

TEST(SweepPlan, GivesEachNodeTheAnswerOfAJobOfItsOwn) {
  const PlanRun sweep = RunPlan(kHenonSweep);
  ASSERT_EQ(sweep.records.size(), 10U);
  for (std::int64_t node = 0; node < 10; ++node) {
    const v1::SweepRecord& record = sweep.records[node].sweep();
    EXPECT_EQ(record.node(), node);
    v1::JobSpec alone =
        ParseSpec("system { name: 'henon3d' } lyapunov { iterates: 400 orbits: 2 transient: 100 }");
    (*alone.mutable_system()->mutable_parameters())["m2"] = record.values(0);
    (*alone.mutable_system()->mutable_parameters())["m1"] = record.values(1);
    const v1::JobSpec resolved = ResolveSpec(alone).value();
    EXPECT_EQ(Serialize(record.lyapunov()), Serialize(RunPlan(resolved).result.lyapunov()));
  }
  EXPECT_EQ(sweep.result.sweep().nodes(), 10);
  EXPECT_EQ(sweep.result.sweep().failed(), 0);
  EXPECT_EQ(sweep.work, 10);
}

TEST(SweepPlan, TakesEveryAnalysisThatGivesNumbers) {
  const std::string stone = "numerics { engine: ENGINE_FAST tolerance: 1e-10 } ";
  const std::string axis = "axes { parameter: 'delta' from: 0.484 to: 0.485 nodes: 2 } ";
  const std::vector<std::string> analyses = {"lyapunov { iterates: 32 transient: 10 }",
                                             "section { iterates: 5 transient: 5 }",
                                             "fixed_point {}",
                                             "continuation { to: 751.9 }",
                                             "manifold { length: 0.05 }",
                                             "separatrix { from: 748.3 to: 748.6 width: 0.05 }",
                                             "hyperbolicity { iterates: 2000 transient: 50 }"};
  for (const std::string& analysis : analyses) {
    const PlanRun sweep = RunPlan("sweep { " + axis + analysis + " } " + stone);
    ASSERT_EQ(sweep.records.size(), 2U) << analysis;
    v1::Result alone = RunPlan(analysis + stone).result;  // delta is 0.485 by default
    if (alone.has_hyperbolicity()) alone.mutable_hyperbolicity()->clear_lmp_graph();
    if (alone.has_continuation()) alone.mutable_continuation()->clear_branch();
    v1::SweepRecord last;
    last.set_node(1);
    last.add_values(0.485);
    ASSERT_TRUE(PutOutcome(alone, last)) << analysis;
    EXPECT_EQ(Serialize(sweep.records[1].sweep()), Serialize(last)) << analysis;
  }
}

TEST(SweepPlan, VariesTheFirstAxisFastestAndHitsTheEnds) {
  const PlanRun sweep = RunPlan(kHenonSweep);
  EXPECT_EQ(sweep.records[0].sweep().values(0), 0.81);
  EXPECT_EQ(sweep.records[4].sweep().values(0), 0.85);
  EXPECT_EQ(sweep.records[4].sweep().values(1), 0);
  EXPECT_EQ(sweep.records[9].sweep().values(0), 0.85);
  EXPECT_EQ(sweep.records[9].sweep().values(1), 0.01);
}

TEST(SweepPlan, GoesOnPastANodeThatFailsAndSaysWhy) {
  // At m2 = 9 every orbit escapes to infinity.
  const PlanRun sweep = RunPlan(
      "system { name: 'henon3d' } sweep { axes { parameter: 'm2' from: 9 to: 0.81 nodes: 2 }"
      "  lyapunov { iterates: 400 orbits: 2 transient: 100 } }");
  ASSERT_EQ(sweep.records.size(), 2U);
  EXPECT_EQ(sweep.records[0].sweep().error().code(),
            static_cast<int>(absl::StatusCode::kOutOfRange));
  EXPECT_NE(sweep.records[0].sweep().error().message().find("escapes"), std::string::npos);
  EXPECT_TRUE(sweep.records[1].sweep().has_lyapunov());
  EXPECT_EQ(sweep.result.sweep().failed(), 1);
}

TEST(SweepPlan, TakesANodeWhoseLevelIsEmptyForAFailureOfThatNode) {
  const PlanRun sweep = RunPlan(
      "sweep { axes { parameter: 'energy' from: 100 to: 752 nodes: 2 }"
      "  lyapunov { iterates: 10 orbits: 1 transient: 0 } } numerics { engine: ENGINE_FAST }");
  ASSERT_EQ(sweep.records.size(), 2U);
  EXPECT_NE(sweep.records[0].sweep().error().message().find("energy: 100"), std::string::npos);
  EXPECT_TRUE(sweep.records[1].sweep().has_lyapunov());
}

TEST(SweepPlan, CarriesTheAttractorAlongWhenItFollows) {
  const PlanRun following = RunPlan(
      "system { name: 'henon3d' } sweep { follow: true"
      "  axes { parameter: 'm2' from: 0.815 to: 0.83 nodes: 4 }"
      "  lyapunov { iterates: 300 orbits: 1 transient: 200 start { x: [0.1, 0.1, 0.1] } } }");
  ASSERT_EQ(following.records.size(), 4U);
  // The second node starts where an orbit of the first is after 200 + 300 iterates.
  v1::JobSpec first = Resolved(
      "system { name: 'henon3d' parameters { key: 'm2' value: 0.815 } }"
      "lyapunov { iterates: 300 orbits: 1 transient: 200 start { x: [0.1, 0.1, 0.1] } }");
  const auto map = MakeMap(first).value();
  Point x = Eigen::Vector3d(0.1, 0.1, 0.1);
  for (int i = 0; i < 500; ++i) {
    x = map->Apply(x, Direction::kForward, Derivative::kNone).value().point;
  }
  v1::JobSpec second = first;
  (*second.mutable_system()->mutable_parameters())["m2"] = following.records[1].sweep().values(0);
  second.mutable_lyapunov()->mutable_start()->clear_x();
  second.mutable_lyapunov()->mutable_start()->mutable_x()->Add(x.begin(), x.end());
  EXPECT_EQ(Serialize(following.records[1].sweep().lyapunov()),
            Serialize(RunPlan(second).result.lyapunov()));
}

TEST(SweepPlan, SaysWhereAnAttractorThatItFollowedWasLost) {
  const PlanRun sweep = RunPlan(
      "system { name: 'henon3d' } sweep { follow: true"
      "  axes { parameter: 'm2' from: 0.85 to: 9.85 nodes: 4 }"
      "  lyapunov { iterates: 100 orbits: 1 transient: 50 } }");
  ASSERT_EQ(sweep.records.size(), 4U);
  EXPECT_TRUE(sweep.records[0].sweep().has_lyapunov());
  EXPECT_EQ(sweep.records[3].sweep().error().message().rfind("the attractor was lost at node 1", 0),
            0U)
      << sweep.records[3].sweep().error().message();
  EXPECT_EQ(sweep.result.sweep().failed(), 3);
}

TEST(SweepPlan, DoesNotShowHowManyThreadsRunItNorAnInterruption) {
  for (const int workers : {1, 3}) {
    ExpectSameBytesWhenInterrupted(Resolved(kHenonSweep), workers, 1);
    ExpectSameBytesWhenInterrupted(
        Resolved("system { name: 'henon3d' } sweep { follow: true"
                 "  axes { parameter: 'm2' from: 0.81 to: 0.85 nodes: 9 }"
                 "  axes { parameter: 'm1' from: 0 to: 0.001 nodes: 3 }"
                 "  lyapunov { iterates: 2000 orbits: 1 transient: 50 } }"),
        workers, 4);
  }
}

TEST(SweepPlan, KeepsAUnitToAboutASecond) {
  const std::string axis = "axes { parameter: 'm2' from: 0.81 to: 0.85 nodes: 10000000 }";
  const auto chains = [&](const std::string& lyapunov) {
    const auto plan = MakePlan(Serialize(Resolved("system { name: 'henon3d' } sweep { " + axis +
                                                  " lyapunov { " + lyapunov + " } }")));
    return (*plan)->chains();
  };
  EXPECT_EQ(chains("iterates: 900 orbits: 1 transient: 100"), 100'000);
  EXPECT_EQ(chains("iterates: 900000 orbits: 1 transient: 100"), 10'000'000);
}

TEST(SweepPlan, KeepsUnitsShortWhereTheAnalysisCountsNoIterates) {
  const auto chains = [](const std::string& analysis) {
    const auto plan = MakePlan(Serialize(Resolved(
        "sweep { axes { parameter: 'delta' from: 0.48 to: 0.49 nodes: 1000 } " + analysis + " }")));
    return (*plan)->chains();
  };
  // These take from milliseconds to seconds each.
  EXPECT_EQ(chains("fixed_point {}"), 40);
  EXPECT_EQ(chains("fixed_point { search: 200 }"), 1000);
  EXPECT_EQ(chains("continuation { to: 747 }"), 250);
  EXPECT_EQ(chains("manifold {}"), 1000);
  EXPECT_EQ(chains("separatrix { from: 748.4 to: 748.5 }"), 1000);
}

TEST(SweepPlan, TakesTheToleranceOfTheAnalysis) {
  const std::string axis = "sweep { axes { parameter: 'energy' from: 751 to: 752 nodes: 2 } ";
  for (const std::string analysis : {"lyapunov {}", "fixed_point {}"}) {
    EXPECT_EQ(Resolved(axis + analysis + "}").numerics().tolerance(),
              Resolved(analysis).numerics().tolerance());
  }
}

TEST(SweepPlan, RefusesBadSpecificationsNamingTheField) {
  const std::vector<BadSpecification> table = {
      {"sweep { lyapunov {} }", "axes: 0 is not allowed", "[1, 2]"},
      {"sweep { axes { parameter: 'energy' from: 1 to: 2 nodes: 2 } }", "sweep.analysis: missing",
       "lyapunov"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 1 } lyapunov {} }",
       "axes[0].nodes: 1 is not allowed", "[2, 10000000]"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 1000000000 } lyapunov {} }",
       "axes[0].nodes: 1000000000 is not allowed", "[2, 10000000]"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 10000 }"
       "        axes { parameter: 'delta' from: 0.4 to: 0.5 nodes: 10000 } lyapunov {} }",
       "axes: 1e+08 nodes in all", "at most 10000000"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 3 }"
       "        axes { parameter: 'energy' from: 0.4 to: 0.5 nodes: 3 } lyapunov {} }",
       "axes[1].parameter: energy", "other axis"},
      {"sweep { axes { parameter: 'energy' to: 753 nodes: 3 } lyapunov {} }",
       "axes[0].from: missing", ""},
      {"sweep { axes { parameter: 'energy' from: 753 nodes: 3 } lyapunov {} }",
       "axes[0].to: missing", ""},
      {"sweep { axes { parameter: 'energy' from: 753 to: 753 nodes: 3 } lyapunov {} }",
       "axes[0].to: 753", ""},
      {"sweep { axes { parameter: 'energy' from: nan to: 753 nodes: 3 } lyapunov {} }",
       "axes[0].energy: nan", ""},
      {"sweep { axes { parameter: 'mass' from: -1 to: 2 nodes: 3 } lyapunov {} }",
       "axes[0].mass: -1 is not allowed", "(0, inf)"},
      {"sweep { axes { parameter: 'spin' from: 1 to: 2 nodes: 3 } lyapunov {} }",
       "axes[0].spin: no parameter of celtic-stone", "energy"},
      {"sweep { axes { parameter: 'energy' from: 752 to: 753 nodes: 3 } lyapunov { iterates: 0 } }",
       "iterates: 0 is not allowed", ""},
      {"sweep { axes { parameter: 'energy' from: 1 to: 2 nodes: 3 } lyapunov {} }",
       "energy: 1 is not allowed", "potential energy"},
  };
  for (const BadSpecification& bad : table) ExpectRefused(bad);
}

}  // namespace
}  // namespace celt::plans
