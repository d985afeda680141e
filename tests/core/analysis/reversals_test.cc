#include "core/analysis/reversals.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "gtest/gtest.h"

namespace celt {
namespace {

std::int64_t Count(const std::vector<double>& turns) {
  Reversals reversals;
  for (const double turn : turns) reversals.Take(turn);
  return reversals.count;
}

TEST(Reversals, TurningOneWayIsNone) {
  EXPECT_EQ(Count({0, 0.5, 1, 3, 10}), 0);
  EXPECT_EQ(Count({0, -0.5, -1, -3}), 0);
}

TEST(Reversals, EachTurningBackIsOne) {
  EXPECT_EQ(Count({0, 1, 0}), 1);
  EXPECT_EQ(Count({0, -1, 0, -1}), 2);
  EXPECT_EQ(Count({0, 1, 0.5, 2, -2}), 3);
}

TEST(Reversals, WobblingIsNone) {
  Reversals reversals;
  for (int i = 0; i < 1000; ++i) reversals.Take(0.12 * std::sin(i));
  EXPECT_EQ(reversals.count, 0);
  // Nor does it disguise one.
  for (int i = 0; i < 1000; ++i) reversals.Take(0.01 * i + 0.12 * std::sin(i));
  for (int i = 0; i < 1000; ++i) reversals.Take(10 - 0.01 * i + 0.12 * std::sin(i));
  EXPECT_EQ(reversals.count, 1);
}

TEST(Reversals, DoNotDependOnHowOftenOneLooks) {
  for (const int steps : {40, 400, 4000}) {
    Reversals reversals;
    for (int i = 0; i <= steps; ++i) {
      reversals.Take(2 * std::sin(6 * std::numbers::pi * i / steps));
    }
    EXPECT_EQ(reversals.count, 6) << steps;  // three waves, two extremes each
  }
}

}  // namespace
}  // namespace celt
