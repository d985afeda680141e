#pragma once

#include "core/map/map.h"

namespace celt {

/// Carries an orthonormal frame of tangent vectors along an orbit: frame, log_stretch ← Q,
/// log_stretch + ln diag R of jacobian · frame = QR with R_ii > 0. False, with nothing changed,
/// when some R_ii is zero: a direction is crushed and its exponent is −∞. Precondition: frame and
/// jacobian are n×n, log_stretch has n entries.
bool PushFrame(const SquareMatrix& jacobian, SquareMatrix& frame, Point& log_stretch);

}  // namespace celt
