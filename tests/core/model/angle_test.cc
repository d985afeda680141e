#include "core/model/angle.h"

#include <numbers>

#include "gtest/gtest.h"

namespace celt {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(WrapToTurn, StaysInsideTheHalfOpenTurn) {
  EXPECT_EQ(WrapToTurn(0), 0);
  EXPECT_EQ(WrapToTurn(2 * kPi), 0);
  EXPECT_EQ(WrapToTurn(-1e-20), 0);
  EXPECT_DOUBLE_EQ(WrapToTurn(-1), 2 * kPi - 1);
  EXPECT_DOUBLE_EQ(WrapToTurn(14 * kPi + 3), 3);
}

TEST(WrapToHalfTurns, KeepsTheUpperEndAndNotTheLower) {
  EXPECT_EQ(WrapToHalfTurns(kPi), kPi);
  EXPECT_EQ(WrapToHalfTurns(-kPi), kPi);
  EXPECT_DOUBLE_EQ(WrapToHalfTurns(kPi + 1), 1 - kPi);
  EXPECT_DOUBLE_EQ(WrapToHalfTurns(-6 * kPi - 0.5), -0.5);
}

}  // namespace
}  // namespace celt
