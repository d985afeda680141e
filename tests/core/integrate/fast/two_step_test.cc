#include "core/integrate/fast/two_step.h"

#include <cmath>

#include "gtest/gtest.h"

namespace celt::fast {
namespace {

double NodeNow(int stage) { return stage == kEarlyStage ? kEarlyNode : kNodes[stage]; }

/// Σ value · node^degree, which is to be the integral from 0 to `end`.
template <std::size_t kNow, std::size_t kBefore>
double Integral(const TwoStepRow<kNow, kBefore>& row, int degree) {
  double sum = 0;
  for (const Coefficient& c : row.now) sum += c.value * std::pow(NodeNow(c.stage), degree);
  for (const Coefficient& c : row.before) sum += c.value * std::pow(kNodes[c.stage] - 1, degree);
  return sum;
}

template <std::size_t kNow, std::size_t kBefore>
void ExpectExact(const TwoStepRow<kNow, kBefore>& row, double end) {
  const int nodes = kNow + kBefore;
  for (int degree = 0; degree < nodes; ++degree) {
    // Coefficients of up to 2 that cancel, rounded.
    EXPECT_NEAR(Integral(row, degree), std::pow(end, degree + 1) / (degree + 1), 1e-15) << degree;
  }
  // And no further: the test would notice.
  EXPECT_GT(std::abs(Integral(row, nodes) - std::pow(end, nodes + 1) / (nodes + 1)), 1e-6);
}

TEST(TwoStepRows, IntegratePolynomialsAsFarAsTheyHaveNodes) {
  ExpectExact(kEarlyRow, kEarlyNode);
  ExpectExact(kFifthRow, kNodes[5]);
  ExpectExact(kSixthRow, kNodes[6]);
}

TEST(TwoStepRows, AreOfNoLessOrderThanTheRowsTheyStandInFor) {
  // Verner's rows 5 and 6 integrate polynomials up to the third degree.
  for (const int stage : {5, 6}) {
    for (int degree = 0; degree <= 4; ++degree) {
      double sum = 0;
      for (int i = kRow[stage]; i < kRow[stage + 1]; ++i) {
        const Coefficient& c = kCoefficients[i];
        sum += c.value * std::pow(kNodes[c.stage], degree);
      }
      const double error = std::abs(sum - std::pow(kNodes[stage], degree + 1) / (degree + 1));
      if (degree <= 3) {
        EXPECT_LT(error, 1e-15) << stage << " " << degree;
      } else {
        EXPECT_GT(error, 1e-6) << stage;
      }
    }
  }
}

}  // namespace
}  // namespace celt::fast
