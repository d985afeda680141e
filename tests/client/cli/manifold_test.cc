#include "client/cli/manifold.h"

#include "gmock/gmock.h"
#include "gtest/gtest.h"
#include "tests/client/fake_service.h"
#include "tests/client/run_celt.h"

namespace celt::cli {
namespace {

v1::Point At(double l) {
  v1::Point point;
  point.set_l(l);
  point.set_l_over_g(-0.5);
  point.set_h_over_g(-0.25);
  return point;
}

v1::Result Both() {
  v1::Result result;
  v1::ManifoldResult& manifold = *result.mutable_manifold();
  *manifold.mutable_saddle()->add_points() = At(2);
  manifold.mutable_saddle()->set_type("saddle 2-1");
  manifold.mutable_saddle()->add_multipliers()->set_re(-1.25);
  manifold.mutable_saddle()->add_multipliers()->set_re(0.5);
  for (const int sign : {1, -1}) {
    v1::ManifoldSide& side = *manifold.add_sides();
    side.set_side(sign);
    side.set_points(1200);
    side.set_length(3.01);
    side.set_end(sign > 0 ? "length" : "lost");
    if (sign < 0) side.set_message("it escapes");
    side.mutable_fate()->set_end(sign > 0 ? "tends to a cycle" : "wanders");
    side.mutable_fate()->set_side(1);
    side.mutable_fate()->set_changes(sign > 0 ? 0 : 2);
    side.mutable_fate()->set_iterates(80);
    *side.mutable_fate()->mutable_point() = At(2.5);
  }
  manifold.mutable_accuracy()->set_map_error(3e-11);
  manifold.mutable_accuracy()->set_jacobian_error(2e-10);
  return result;
}

TEST(Manifold, SendsWhatWasGiven) {
  FakeService service;
  v1::StreamResultsResponse answer;
  *answer.mutable_result() = Both();
  service.scripts = {{{answer}, {}}};
  const Outcome outcome =
      RunCelt({"manifold", "--near", "2.1,-0.6,-0.3", "--period", "2", "--stable", "--length", "3",
               "--spacing", "0.02", "--turning", "0.2", "--most-points", "5000"},
              {.server = service.address()});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const v1::ManifoldSpec spec = service.submitted().manifold();
  EXPECT_EQ(spec.near().h_over_g(), -0.3);
  EXPECT_EQ(spec.period(), 2);
  EXPECT_TRUE(spec.stable());
  EXPECT_EQ(spec.length(), 3);
  EXPECT_EQ(spec.spacing(), 0.02);
  EXPECT_EQ(spec.turning(), 0.2);
  EXPECT_EQ(spec.most_points(), 5000);
}

TEST(Manifold, CsvIsThePointsOfBothSides) {
  v1::Record record;
  record.mutable_manifold()->set_side(-1);
  record.mutable_manifold()->set_arc_length(0.125);
  record.mutable_manifold()->set_generation(4);
  *record.mutable_manifold()->mutable_point() = At(2.5);
  const CsvRow expected = {{"side", "-1"}, {"arc_length", "0.125"}, {"generation", "4"},
                           {"l", "2.5"},   {"l_over_g", "-0.5"},    {"h_over_g", "-0.25"}};
  EXPECT_EQ(MakeManifold()->Csv(record), expected);
  EXPECT_TRUE(MakeManifold()->Csv(Both()).empty());
  EXPECT_EQ(MakeManifold()->Line(record), "");
}

TEST(Manifold, TableHasTheSaddleItsSidesAndTheirFates) {
  const FakeService service;
  EXPECT_EQ(MakeManifold()->Table(service.job, Both()),
            R"(Unstable manifold of a saddle 2-1 of celtic-stone at energy 752

  point        (2.000000, -0.500000, -0.250000)
  multipliers -1.2500000000, 0.5000000000
  sides by     the stable manifold

  side  points  length  ended by  its separatrix
  +     1 200   3.01    length    tends to a cycle at (2.500000, -0.500000, -0.250000) after 80 iterates, always on its own side
  −     1 200   3.01    lost      wanders after 80 iterates, last on side +
  side −: it escapes

  map error 3e-11, of its derivative 2e-10
)");
}

}  // namespace
}  // namespace celt::cli
