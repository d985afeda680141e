#include "server/plans/spec.h"

#include <string>

#include "gmock/gmock.h"
#include "google/protobuf/text_format.h"
#include "gtest/gtest.h"
#include "server/plans/serialize.h"

namespace celt::plans {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

v1::JobSpec Parse(const std::string& text) {
  v1::JobSpec spec;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &spec)) << text;
  return spec;
}

v1::JobSpec Resolve(const std::string& text) {
  const auto resolved = ResolveSpec(Parse(text));
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.value_or(v1::JobSpec());
}

TEST(ResolveSpec, FillsInEveryDefault) {
  const v1::JobSpec spec = Resolve("lyapunov {}");
  EXPECT_EQ(spec.system().name(), "celtic-stone");
  EXPECT_EQ(spec.system().parameters_size(), 12);
  EXPECT_EQ(spec.system().parameters().at("energy"), 752);
  EXPECT_EQ(spec.numerics().tolerance(), 1e-11);
  EXPECT_NE(spec.numerics().engine(), v1::ENGINE_UNSPECIFIED);
  EXPECT_EQ(spec.frame(), v1::FRAME_BODY);
  EXPECT_EQ(spec.lyapunov().iterates(), 100'000);
  EXPECT_EQ(spec.lyapunov().orbits(), 16);
  EXPECT_EQ(spec.lyapunov().transient(), 2000);
  EXPECT_EQ(spec.lyapunov().seed(), 1U);
  EXPECT_TRUE(spec.lyapunov().start().has_h_over_g());
}

TEST(ResolveSpec, KeepsWhatIsGiven) {
  const v1::JobSpec spec = Resolve(
      "system { name: 'henon3d' parameters { key: 'm2' value: 0.815 } } numerics { tolerance: 1e-9 "
      "} "
      "lyapunov { iterates: 50 orbits: 2 transient: 0 seed: 0 start { x: [0.1, 0.2, 0.3] } }");
  EXPECT_EQ(spec.system().parameters().at("m2"), 0.815);
  EXPECT_EQ(spec.numerics().tolerance(), 1e-9);
  EXPECT_EQ(spec.lyapunov().iterates(), 50);
  EXPECT_EQ(spec.lyapunov().transient(), 0);
  EXPECT_EQ(spec.lyapunov().seed(), 0U);
  EXPECT_EQ(spec.lyapunov().start().x(2), 0.3);
}

TEST(ResolveSpec, ChangesNothingTheSecondTime) {
  for (const char* text :
       {"lyapunov {}", "frame: FRAME_PAPER lyapunov {}", "system { name: 'lorenz' } lyapunov {}",
        "system { name: 'henon3d' } lyapunov {}"}) {
    const v1::JobSpec once = Resolve(text);
    const auto twice = ResolveSpec(once);
    ASSERT_TRUE(twice.ok()) << twice.status();
    EXPECT_EQ(Serialize(once), Serialize(*twice)) << text;
  }
}

TEST(ResolveSpec, GivesTheDefaultStartInTheFrameOfTheJob) {
  // O* at 752 in the paper's frame, to the six digits that are known of it.
  const v1::Point start = Resolve("frame: FRAME_PAPER lyapunov {}").lyapunov().start();
  EXPECT_NEAR(start.l(), 3.650723, 1e-6);
  EXPECT_NEAR(start.l_over_g(), 0.669144, 1e-6);
  EXPECT_NEAR(start.h_over_g(), -0.384701, 1e-6);
}

TEST(ResolveSpec, ForgetsWhatItDoesNotKnow) {
  v1::JobSpec spec = Parse("lyapunov {}");
  spec.GetReflection()->MutableUnknownFields(&spec)->AddVarint(1234, 5);
  EXPECT_EQ(Serialize(*ResolveSpec(spec)), Serialize(Resolve("lyapunov {}")));
}

struct BadSpec {
  const char* text;
  const char* beginning;  ///< of the message: the field
  const char* part;       ///< of the message: the value or what is allowed
};

class BadSpecTest : public ::testing::TestWithParam<BadSpec> {};

TEST_P(BadSpecTest, IsRefusedWithTheFieldsName) {
  const auto resolved = ResolveSpec(Parse(GetParam().text));
  EXPECT_EQ(resolved.status().code(), absl::StatusCode::kInvalidArgument) << resolved.status();
  const std::string message(resolved.status().message());
  EXPECT_THAT(message, StartsWith(GetParam().beginning));
  EXPECT_THAT(message, HasSubstr(GetParam().part));
  EXPECT_EQ(message.find('\n'), std::string::npos) << "more than a line: " << message;
}

INSTANTIATE_TEST_SUITE_P(
    Fields, BadSpecTest,
    ::testing::Values(
        BadSpec{"", "analysis:", "missing"},
        BadSpec{"system { name: 'rattle' } lyapunov {}", "system:", "celtic-stone"},
        BadSpec{"system { parameters { key: 'rho' value: 1 } } lyapunov {}", "rho:", "energy"},
        BadSpec{"system { parameters { key: 'mass' value: -1 } } lyapunov {}", "mass:", "-1"},
        BadSpec{"system { parameters { key: 'mass' value: nan } } lyapunov {}", "mass:", "nan"},
        BadSpec{"system { parameters { key: 'energy' value: inf } } lyapunov {}", "energy:", "inf"},
        BadSpec{"system { parameters { key: 'inertia_3' value: 9 } } lyapunov {}", "inertia", "9"},
        BadSpec{"system { parameters { key: 'energy' value: 50 } } lyapunov {}", "energy:", "50"},
        BadSpec{"numerics { tolerance: 0 } lyapunov {}", "tolerance:", "0"},
        BadSpec{"numerics { tolerance: 0.1 } lyapunov {}", "tolerance:", "0.1"},
        BadSpec{"numerics { tolerance: nan } lyapunov {}", "tolerance:", "nan"},
        BadSpec{"system { name: 'lorenz' } numerics { engine: ENGINE_FAST } lyapunov {}",
                "engine:", "fast"},
        BadSpec{"system { name: 'lorenz' } frame: FRAME_PAPER lyapunov {}", "frame:", "lorenz"},
        BadSpec{"lyapunov { iterates: 0 }", "iterates:", "0 is not allowed"},
        BadSpec{"lyapunov { iterates: -5 }", "iterates:", "-5"},
        BadSpec{"lyapunov { iterates: 7 }", "iterates:", "[16, "},
        BadSpec{"lyapunov { iterates: 9000000000000000000 }", "iterates:", "1000000000000]"},
        BadSpec{"lyapunov { orbits: 0 }", "orbits:", "[1, 4096]"},
        BadSpec{"lyapunov { orbits: -1 }", "orbits:", "-1"},
        BadSpec{"lyapunov { orbits: 4097 }", "orbits:", "4097"},
        BadSpec{"lyapunov { transient: -1 }", "transient:", "-1"},
        BadSpec{"lyapunov { transient: 9000000000000000000 }", "transient:", "9000000000000000000"},
        BadSpec{"lyapunov { start {} }", "l:", "missing"},
        BadSpec{"lyapunov { start { l: 1 h_over_g: 0 } }", "l_over_g:", "missing"},
        BadSpec{"lyapunov { start { x: [1, 2, 3] } }", "x:", "l_over_g"},
        BadSpec{"lyapunov { start { l: nan l_over_g: 0 h_over_g: 0 } }", "l:", "nan"},
        BadSpec{"lyapunov { start { l: 1 l_over_g: 1 h_over_g: 0 } }", "l_over_g:", "1"},
        BadSpec{"lyapunov { start { l: 1 l_over_g: -1.5 h_over_g: 0 } }", "l_over_g:", "-1.5"},
        BadSpec{"lyapunov { start { l: 1 l_over_g: 0 h_over_g: 2 } }", "h_over_g:", "2"},
        BadSpec{"system { name: 'lorenz' } lyapunov { start { x: [1, 2] } }", "point:", "2"},
        BadSpec{"system { name: 'lorenz' } lyapunov { start { x: [1, 2, nan] } }", "z:", "nan"},
        BadSpec{"system { name: 'lorenz' } lyapunov { start { l: 1 } }", "l,", "x"},
        BadSpec{"system { name: 'lorenz' } lyapunov { start { x: [1,2,3,4,5,6,7,8,9] } }",
                "x:", "9"},
        // The given start is in the domain, orbits drawn around it are not.
        BadSpec{"lyapunov { orbits: 64 start { l: 1 l_over_g: -0.3 h_over_g: 0.99999 } }",
                "h_over_g:", "start of orbit"}));

TEST(ResolveSpec, RefusesNumbersOfEnumsThatItDoesNotKnow) {
  v1::JobSpec spec = Parse("lyapunov {}");
  spec.set_frame(static_cast<v1::Frame>(77));
  EXPECT_THAT(std::string(ResolveSpec(spec).status().message()), HasSubstr("frame: 77"));
  spec = Parse("lyapunov {}");
  spec.mutable_numerics()->set_engine(static_cast<v1::Engine>(77));
  EXPECT_THAT(std::string(ResolveSpec(spec).status().message()), HasSubstr("engine: 77"));
}

TEST(Serialize, DoesNotDependOnTheOrderOfAMap) {
  v1::System a;
  v1::System b;
  for (int i = 0; i < 20; ++i) (*a.mutable_parameters())[std::to_string(i)] = i;
  for (int i = 20; i-- > 0;) (*b.mutable_parameters())[std::to_string(i)] = i;
  EXPECT_EQ(Serialize(a), Serialize(b));
}

}  // namespace
}  // namespace celt::plans
