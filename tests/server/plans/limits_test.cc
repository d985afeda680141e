#include "server/plans/limits.h"

#include <string>

#include "gmock/gmock.h"
#include "google/protobuf/text_format.h"
#include "gtest/gtest.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

using ::testing::StartsWith;

std::string Refusal(const std::string& text, const SpecLimits& limits) {
  v1::JobSpec spec;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &spec)) << text;
  const auto resolved = ResolveSpec(spec);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  if (!resolved.ok()) return "";
  const absl::Status status = CheckLimits(*resolved, limits);
  EXPECT_TRUE(status.ok() || absl::IsInvalidArgument(status)) << status;
  return std::string(status.message());
}

SpecLimits Limits() {
  SpecLimits limits;
  limits.iterates = 1000;
  limits.nodes = 20;
  limits.records = 50;
  return limits;
}

constexpr const char* kSweep =
    "system { name: 'henon3d' } sweep { axes { parameter: 'm1' from: 0 to: 0.1 nodes: 10 } "
    "lyapunov { iterates: 90 orbits: 1 transient: 10 } }";

TEST(SpecLimits, LetPassWhatIsJustWithin) {
  EXPECT_EQ(Refusal("lyapunov { iterates: 800 orbits: 2 transient: 100 }", Limits()), "");
  EXPECT_EQ(Refusal("section { iterates: 50 transient: 950 }", Limits()), "");
  EXPECT_EQ(Refusal(kSweep, Limits()), "");
}

TEST(SpecLimits, NameTheFieldThatAsksForMore) {
  EXPECT_EQ(Refusal("lyapunov { iterates: 801 orbits: 2 transient: 100 }", Limits()),
            "lyapunov.iterates: 1001 iterates are more than this server's 1000");
  EXPECT_THAT(Refusal("section { iterates: 51 }", Limits()), StartsWith("section.iterates: "));
  EXPECT_THAT(Refusal("orbit { time: 10 step: 0.1 }", Limits()), StartsWith("orbit.step: "));
}

TEST(SpecLimits, CountEveryNodeOfASweep) {
  SpecLimits limits = Limits();
  limits.iterates = 999;
  EXPECT_EQ(Refusal(kSweep, limits),
            "sweep.lyapunov.iterates: 1000 iterates at all nodes are more than this server's 999");
  limits = Limits();
  limits.nodes = 9;
  EXPECT_EQ(Refusal(kSweep, limits), "sweep.axes: 10 nodes are more than this server's 9");
}

TEST(SpecLimits, AreNoneByDefault) {
  EXPECT_EQ(Refusal("lyapunov { iterates: 1000000000000 }", {}), "");
}

}  // namespace
}  // namespace celt::plans
