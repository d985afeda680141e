#include "core/analysis/frame.h"

#include <cmath>

#include "Eigen/LU"
#include "Eigen/QR"
#include "core/analysis/random.h"
#include "gtest/gtest.h"

namespace celt {
namespace {

SquareMatrix Draw(int n, Uniform& uniform) {
  SquareMatrix matrix(n, n);
  for (double& entry : matrix.reshaped()) entry = uniform();
  return matrix;
}

class Frames : public testing::TestWithParam<int> {};

TEST_P(Frames, AreTheQOfQrWithAPositiveDiagonal) {
  const int n = GetParam();
  Uniform uniform(7);
  for (int trial = 0; trial < 50; ++trial) {
    const SquareMatrix jacobian = Draw(n, uniform);
    SquareMatrix frame = Eigen::HouseholderQR<SquareMatrix>(Draw(n, uniform)).householderQ();
    Point log_stretch = Point::Zero(n);
    const SquareMatrix pushed = jacobian * frame;
    ASSERT_TRUE(PushFrame(jacobian, frame, log_stretch));
    // Orthonormal to rounding; condition numbers of these matrices stay below 1000.
    EXPECT_LT((frame.transpose() * frame - SquareMatrix::Identity(n, n)).norm(), 1e-13);
    const SquareMatrix r = frame.transpose() * pushed;
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(std::log(r(i, i)), log_stretch[i], 1e-11);
      for (int j = 0; j < i; ++j) EXPECT_NEAR(r(i, j), 0, 1e-13);
    }
  }
}

TEST_P(Frames, StretchByTheDeterminantInAll) {
  const int n = GetParam();
  Uniform uniform(8);
  const SquareMatrix jacobian = Draw(n, uniform);
  SquareMatrix frame = SquareMatrix::Identity(n, n);
  Point log_stretch = Point::Zero(n);
  ASSERT_TRUE(PushFrame(jacobian, frame, log_stretch));
  EXPECT_NEAR(log_stretch.sum(), std::log(std::abs(jacobian.determinant())), 1e-12);
}

TEST_P(Frames, StayAsTheyAreWhereADirectionIsCrushed) {
  const int n = GetParam();
  SquareMatrix jacobian = SquareMatrix::Identity(n, n);
  jacobian.col(1).setZero();
  SquareMatrix frame = SquareMatrix::Identity(n, n);
  Point log_stretch = Point::Zero(n);
  EXPECT_FALSE(PushFrame(jacobian, frame, log_stretch));
  EXPECT_EQ(frame, SquareMatrix(SquareMatrix::Identity(n, n)));
  EXPECT_EQ(log_stretch, Point(Point::Zero(n)));
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Frames, testing::Values(2, 3, 4));

}  // namespace
}  // namespace celt
