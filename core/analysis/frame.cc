#include "core/analysis/frame.h"

#include <cmath>

#include "Eigen/Geometry"
#include "Eigen/QR"

namespace celt {
namespace {

bool PushAny(const SquareMatrix& jacobian, SquareMatrix& frame, Point& log_stretch) {
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

/// Three dimensions, where nearly all frames are, in a tenth of the time: Gram–Schmidt, the second
/// vector twice so that it is orthogonal to rounding, and the third by the cross product.
bool PushThree(const SquareMatrix& jacobian, SquareMatrix& frame, Point& log_stretch) {
  const Eigen::Matrix3d pushed = jacobian.topLeftCorner<3, 3>() * frame.topLeftCorner<3, 3>();
  Eigen::Vector3d r;
  r[0] = pushed.col(0).norm();
  const Eigen::Vector3d first = pushed.col(0) / r[0];
  Eigen::Vector3d second = pushed.col(1) - first.dot(pushed.col(1)) * first;
  second -= first.dot(second) * first;
  r[1] = second.norm();
  second /= r[1];
  Eigen::Vector3d third = first.cross(second);
  r[2] = third.dot(pushed.col(2));
  if (r[2] < 0) {
    third = -third;
    r[2] = -r[2];
  }
  if (!(r.minCoeff() > 0)) return false;
  frame.col(0) = first;
  frame.col(1) = second;
  frame.col(2) = third;
  for (int i = 0; i < 3; ++i) log_stretch[i] += std::log(r[i]);
  return true;
}

}  // namespace

bool PushFrame(const SquareMatrix& jacobian, SquareMatrix& frame, Point& log_stretch) {
  return frame.rows() == 3 ? PushThree(jacobian, frame, log_stretch)
                           : PushAny(jacobian, frame, log_stretch);
}

}  // namespace celt
