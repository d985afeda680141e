#include "server/plans/accuracy.h"

#include <string>

#include "gmock/gmock.h"
#include "google/protobuf/text_format.h"
#include "gtest/gtest.h"
#include "server/plans/spec.h"

namespace celt::plans {
namespace {

using ::testing::HasSubstr;

v1::JobSpec Resolve(const std::string& text) {
  v1::JobSpec spec;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &spec)) << text;
  const auto resolved = ResolveSpec(spec);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.value_or(v1::JobSpec());
}

v1::Accuracy AccuracyOf(const std::string& text, const Point& point) {
  const v1::JobSpec spec = Resolve(text);
  const auto map = MakeMap(spec);
  EXPECT_TRUE(map.ok()) << map.status();
  const auto accuracy = MeasureAccuracy(spec, **map, std::vector{point});
  EXPECT_TRUE(accuracy.ok()) << accuracy.status();
  return *accuracy;
}

const Point kStonePoint = Eigen::Vector3d(2.15, -0.67, -0.38);

TEST(MeasureAccuracy, GivesTheMapsErrorsAtTheTolerance) {
  for (const double tolerance : {1e-8, 1e-10, 1e-12}) {
    const v1::Accuracy accuracy = AccuracyOf(
        "lyapunov {} numerics { tolerance: " + std::to_string(tolerance * 1e12) + "e-12 }",
        kStonePoint);
    EXPECT_EQ(accuracy.sample(), 1);
    // From a hundredth of what the engine states at most, 5 tolerances and 30, up to that.
    EXPECT_GT(accuracy.map_error(), 0.05 * tolerance) << tolerance;
    EXPECT_LT(accuracy.map_error(), 30 * tolerance) << tolerance;
    EXPECT_LT(accuracy.jacobian_error(), 150 * tolerance) << tolerance;
    EXPECT_GT(accuracy.drift(), 0);
  }
}

TEST(MeasureAccuracy, DoesNotCallTheLeastToleranceExact) {
  const v1::Accuracy accuracy =
      AccuracyOf("lyapunov {} numerics { tolerance: 1e-14 }", kStonePoint);
  EXPECT_GT(accuracy.map_error(), 0);
  EXPECT_LT(accuracy.map_error(), 1e-12);
}

TEST(MeasureAccuracy, FindsNoErrorInAFormula) {
  const v1::Accuracy accuracy =
      AccuracyOf("system { name: 'henon3d' } lyapunov {}", Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(accuracy.sample(), 1);
  EXPECT_EQ(accuracy.map_error(), 0);
  EXPECT_EQ(accuracy.jacobian_error(), 0);
  EXPECT_EQ(accuracy.drift(), 0);
}

TEST(WarnIfNotBelow, SpeaksUpWhereTheMapsErrorShows) {
  v1::Accuracy accuracy;
  WarnIfNotBelow("lambda1", 1e-6, 1e-4, accuracy);
  WarnIfNotBelow("lambda2", 0, 0, accuracy);
  EXPECT_EQ(accuracy.warnings_size(), 0);
  WarnIfNotBelow("lambda3", 5e-5, 1e-4, accuracy);
  ASSERT_EQ(accuracy.warnings_size(), 1);
  EXPECT_THAT(accuracy.warnings(0), HasSubstr("lambda3: the error of the map gives it an error of "
                                              "5.0e-05, not well below the standard error of "
                                              "1.0e-04"));
}

}  // namespace
}  // namespace celt::plans
