#pragma once

#include <cmath>

#include "core/analysis/shooting.h"

namespace celt {

/// What is known in closed form of the fixed points (x, x, x) of the three-dimensional Hénon map:
/// m1 = x² + (1 − b − m2 − a) x, and the multipliers are the zeros of
/// χ(μ) = μ³ − t μ² − m2 μ − b with t = a − 2x.
struct HenonFixedPoints {
  double m2;
  double a;
  double b;

  double M1(double x) const { return x * x + (1 - b - m2 - a) * x; }
  /// The two points that there are at a value of m1 meet.
  double FoldX() const { return (b + m2 + a - 1) / 2; }
  /// χ(−1) = 0.
  double DoublingX() const { return (a - m2 + b + 1) / 2; }
  /// The pair is e^{±iθ}, the third multiplier b: m2 = −1 − 2 b cos θ, t = b + 2 cos θ.
  double Cosine() const { return -(1 + m2) / (2 * b); }
  double NeimarkSackerX() const { return (a - b - 2 * Cosine()) / 2; }

  Multiplier Characteristic(Multiplier mu, double x) const {
    return mu * mu * mu - (a - 2 * x) * mu * mu - m2 * mu - b;
  }
};

}  // namespace celt
