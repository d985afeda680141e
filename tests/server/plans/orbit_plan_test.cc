#include "server/plans/orbit_plan.h"

#include <cmath>
#include <numbers>

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "plans/plan_testing.h"

namespace celt::plans {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr char kReversing[] = "state: [0, 0, -14, 0.01, 0.01, 0.9999] ";

v1::OrbitRecord At(const PlanRun& run, std::size_t i) { return run.records.at(i).orbit(); }

std::string Orbit(const std::string& text) { return "orbit { " + text + " }"; }

TEST(OrbitPlan, ReturnsToTheFixedPointOfTheSection) {
  const PlanRun run = RunPlan(Orbit("time: 0.792136027186 step: 0.1"));
  ASSERT_THAT(run.records, SizeIs(9));
  const v1::OrbitRecord start = At(run, 0);
  const v1::OrbitRecord end = At(run, 8);
  EXPECT_EQ(start.time(), 0);
  EXPECT_NEAR(start.g(), std::numbers::pi, 1e-12);
  EXPECT_NEAR(start.andoyer().l_over_g(), -0.669144118368, 1e-14);
  EXPECT_EQ(end.time(), 0.792136027186);
  // The point is given to 1e-12, and M is about 60.
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(end.momentum(i), start.momentum(i), 1e-8);
    EXPECT_NEAR(end.gamma(i), start.gamma(i), 1e-9);
  }
  const v1::OrbitResult& result = run.result.orbit();
  EXPECT_EQ(result.records(), 9);
  EXPECT_EQ(result.time(), end.time());
  EXPECT_EQ(result.turns(), end.turns());
  EXPECT_NEAR(result.energy(), 752, 1e-10);
  EXPECT_LT(result.energy_drift(), 1e-10);
  EXPECT_LT(result.gamma_drift(), 1e-10);
  EXPECT_EQ(run.work, 8);
}

TEST(OrbitPlan, GivesAnglesInTheFrameOfTheJob) {
  const v1::OrbitRecord start = At(RunPlan("frame: FRAME_PAPER " + Orbit("time: 0.1")), 0);
  EXPECT_NEAR(start.andoyer().l(), 3.650723, 1e-6);
  EXPECT_NEAR(start.andoyer().l_over_g(), 0.669144, 1e-6);
  // g = pi of the body is g = 0 of the paper, from either side of a whole turn.
  EXPECT_NEAR(std::sin(start.g() / 2), 0, 1e-12);
}

TEST(OrbitPlan, CountsTheStonesReversals) {
  const PlanRun run = RunPlan(Orbit(std::string(kReversing) + "time: 40 step: 0.1"));
  EXPECT_EQ(run.result.orbit().reversals(), 2);
  EXPECT_NEAR(At(run, 0).spin_rate(), -2, 0.01);
  EXPECT_GT(At(run, 120).spin_rate(), 1.9);
  EXPECT_LT(At(run, 350).spin_rate(), -1.9);
}

TEST(OrbitPlan, JobOfAStateHasItsEnergy) {
  const v1::JobSpec spec = Resolved(Orbit(kReversing));
  const PlanRun run = RunPlan(spec);
  EXPECT_EQ(run.result.orbit().energy(), spec.system().parameters().at("energy"));
  EXPECT_LT(run.result.orbit().energy(), 200);
  EXPECT_EQ(Serialize(*ResolveSpec(spec)), Serialize(spec));
}

TEST(OrbitPlan, EndsAfterTurns) {
  const PlanRun run = RunPlan(Orbit(std::string(kReversing) + "time: 1000 turns: 1"));
  EXPECT_GE(std::abs(run.result.orbit().turns()), 1);
  EXPECT_LT(std::abs(At(run, run.records.size() - 2).turns()), 1);
  EXPECT_NEAR(run.result.orbit().time(), 3.2, 0.1);
  EXPECT_EQ(run.result.orbit().records(), std::ssize(run.records));
}

TEST(OrbitPlan, BackwardRunsTowardsThePast) {
  const PlanRun there = RunPlan(Orbit(std::string(kReversing) + "time: 1 step: 0.5"));
  v1::JobSpec spec = ParseSpec(Orbit("time: 1 step: 0.5 direction: DIRECTION_BACKWARD"));
  const v1::OrbitRecord turn = At(there, 2);
  for (const double m : turn.momentum()) spec.mutable_orbit()->add_state(m);
  for (const double g : turn.gamma()) spec.mutable_orbit()->add_state(g);
  const PlanRun back = RunPlan(*ResolveSpec(spec));
  EXPECT_EQ(At(back, 2).time(), -1);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(At(back, 2).momentum(i), At(there, 0).momentum(i), 1e-8);
}

TEST(OrbitPlan, StoneAtRestHasNoAnglesAndNoDrift) {
  const PlanRun run = RunPlan(Orbit("state: [0, 0, 0, 0, 0, 1] time: 0.1"));
  ASSERT_TRUE(run.status.ok()) << run.status;
  for (const v1::Record& record : run.records) {
    EXPECT_FALSE(record.orbit().has_andoyer());
    EXPECT_EQ(record.ShortDebugString().find("nan"), std::string::npos);
  }
  EXPECT_EQ(run.result.orbit().energy_drift(), 0);
}

TEST(OrbitPlan, SameBytesHoweverInterrupted) {
  // Two units and a half.
  const v1::JobSpec spec = Resolved(Orbit(std::string(kReversing) + "time: 5 step: 0.001"));
  ExpectSameBytesWhenInterrupted(spec, 2, 2000);
}

TEST(OrbitPlan, LostOrbitKeepsItsRecordsAndSaysWhy) {
  // Rolls over its edge: gamma3 comes to 0, in steps that a loose tolerance leaves longer.
  const PlanRun run = RunPlan("numerics { tolerance: 1e-7 } " +
                              Orbit("start { l: 2 l_over_g: 0.7 h_over_g: -0.8 } time: 100"));
  EXPECT_EQ(run.status.code(), absl::StatusCode::kOutOfRange);
  EXPECT_THAT(std::string(run.status.message()), HasSubstr("orbit lost at t = "));
  EXPECT_GE(run.records.size(), 2U);
}

TEST(OrbitSpec, FillsInEveryDefault) {
  const v1::JobSpec spec = Resolved("numerics { engine: ENGINE_FAST } orbit {}");
  EXPECT_EQ(spec.numerics().engine(), v1::ENGINE_ARKODE);
  EXPECT_EQ(spec.orbit().time(), 10);
  EXPECT_EQ(spec.orbit().step(), 0.01);
  EXPECT_EQ(spec.orbit().direction(), v1::DIRECTION_FORWARD);
  EXPECT_FALSE(spec.orbit().has_turns());
  EXPECT_EQ(Resolved("numerics { engine: ENGINE_CVODE } orbit {}").numerics().engine(),
            v1::ENGINE_CVODE);
  EXPECT_EQ(Resolved("orbit { time: 0.001 }").orbit().step(), 0.001);
}

TEST(OrbitSpec, RefusesWhatMakesNoSense) {
  for (const BadSpecification& bad : {
           BadSpecification{"system { name: 'henon3d' } orbit {}", "system:", "celtic-stone"},
           BadSpecification{"orbit { time: 0 }", "time:", "0 is not allowed"},
           BadSpecification{"orbit { time: nan }", "time:", "nan"},
           BadSpecification{"orbit { time: inf }", "time:", "inf"},
           BadSpecification{"orbit { step: 0 }", "step:", "0 is not allowed"},
           BadSpecification{"orbit { time: 1 step: 2 }", "step:", "(0, 1]"},
           BadSpecification{"orbit { time: 1e8 step: 5000 }", "step:", "(0, 1000]"},
           BadSpecification{"orbit { time: 1e9 }", "time:", "records"},
           BadSpecification{"orbit { turns: -1 }", "turns:", "-1"},
           BadSpecification{"orbit { start { l: 1 l_over_g: 1 h_over_g: 0 } }", "start:", "1"},
           BadSpecification{"orbit { state: [1, 2] }", "state:", "2 numbers"},
           BadSpecification{"orbit { state: [1, 2, 3, 1, 1, 1] }", "state:", "|gamma|"},
           BadSpecification{"orbit { state: [1, 2, 3, 1, 0, 0] }", "state:", "gamma3"},
           BadSpecification{"orbit { state: [nan, 2, 3, 0, 0, 1] }", "state:", "finite"},
           BadSpecification{"orbit { state: [0, 0, 1e200, 0, 0, 1] }", "state:", "finite"},
           BadSpecification{"orbit { state: [1, 2, 3, 0, 0, 1] start { l: 1 } }",
                            "state:", "start"},
           BadSpecification{"system { parameters { key: 'inertia_3' value: 9 } } "
                            "orbit { state: [1, 2, 3, 0, 0, 1] }",
                            "inertia", "9"},
       }) {
    ExpectRefused(bad);
  }
}

}  // namespace
}  // namespace celt::plans
