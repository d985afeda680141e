#include "core/analysis/frame.h"

#include <cmath>

#include "Eigen/QR"

namespace celt {

bool PushFrame(const SquareMatrix& jacobian, SquareMatrix& frame, Point& log_stretch) {
  const SquareMatrix pushed = jacobian * frame;
  const Eigen::HouseholderQR<SquareMatrix> qr(pushed);
  const Point r = qr.matrixQR().diagonal();
  if (!(r.cwiseAbs().minCoeff() > 0)) return false;
  const Eigen::Index n = frame.rows();
  frame = qr.householderQ() * SquareMatrix::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (r[i] < 0) frame.col(i) *= -1;
    log_stretch[i] += std::log(std::abs(r[i]));
  }
  return true;
}

}  // namespace celt
