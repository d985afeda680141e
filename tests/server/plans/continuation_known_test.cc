#include "server/plans/continuation_known.h"

#include <string>

#include "gtest/gtest.h"

namespace celt::plans {
namespace {

v1::ContinuationResult Point(double value, int cycle_points = 0) {
  v1::ContinuationResult found;
  v1::BranchPoint& point = *found.add_branch();
  point.set_value(value);
  for (int i = 0; i < cycle_points; ++i) point.mutable_cycle()->add_points()->set_l(i + 1);
  return found;
}

v1::ContinuationResult After(int count, int cycle_points) {
  std::string known;
  for (int i = 0; i < count; ++i) known = *FoldContinuation(known, Point(i, cycle_points));
  return *KnownContinuation(known);
}

TEST(FoldContinuation, KeepsEveryPointOfAShortBranch) {
  const v1::ContinuationResult result = After(150, 1);
  ASSERT_EQ(result.branch_size(), 150);
  for (int i = 0; i < 150; ++i) EXPECT_EQ(result.branch(i).value(), i);
}

TEST(FoldContinuation, ThinsALongBranchEvenly) {
  std::string known;
  for (int unit = 0; unit < 50; ++unit) {
    v1::ContinuationResult found;
    for (int i = 0; i < 100; ++i) found.MergeFrom(Point(100 * unit + i));
    known = *FoldContinuation(known, found);
  }
  const v1::ContinuationResult result = *KnownContinuation(known);
  // 5000 is thinned twice: every fourth is left.
  ASSERT_EQ(result.branch_size(), 1250);
  for (int i = 0; i < 1250; ++i) EXPECT_EQ(result.branch(i).value(), 4 * i);
}

TEST(FoldContinuation, StaysBelowTheLargestMessage) {
  std::string known;
  v1::ContinuationResult found;
  for (int i = 0; i < 50; ++i) found.MergeFrom(Point(i, 256));
  *found.add_bifurcations()->mutable_cycle() = found.branch(0).cycle();
  for (int unit = 0; unit < 15; ++unit) known = *FoldContinuation(known, found);
  const v1::ContinuationResult result = *KnownContinuation(known);
  EXPECT_LT(result.ByteSizeLong(), 3U << 20U);
  EXPECT_GT(result.branch_size(), 100);
  EXPECT_GE(result.bifurcations_size(), 1);
}

TEST(FoldContinuation, CollectsBifurcationsAndBranchesInOrder) {
  v1::ContinuationResult first;
  first.add_bifurcations()->set_value(1);
  v1::ContinuationResult second;
  second.add_bifurcations()->set_value(2);
  second.add_branches()->set_points(7);
  second.mutable_accuracy()->set_sample(3);
  const std::string known = *FoldContinuation(*FoldContinuation("", first), second);
  const v1::ContinuationResult result = *KnownContinuation(known);
  ASSERT_EQ(result.bifurcations_size(), 2);
  EXPECT_EQ(result.bifurcations(1).value(), 2);
  EXPECT_EQ(result.branches(0).points(), 7);
  EXPECT_EQ(result.accuracy().sample(), 3);
}

}  // namespace
}  // namespace celt::plans
