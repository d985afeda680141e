#include "core/analysis/zero.h"

#include <limits>

namespace celt {
namespace {

constexpr int kMostEvaluations = 200;

/// Where in (0, 1), from b to a, to look next; c is the point that b replaced. ½ unless inverse
/// quadratic interpolation is known to stay in bounds.
double NextFraction(double a, double b, double c, double fa, double fb, double fc) {
  const double xi = (a - b) / (c - b);
  const double phi = (fa - fb) / (fc - fb);
  if (!(phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)) return 0.5;
  return fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
}

bool Same(double a, double b) { return (a < 0) == (b < 0); }

}  // namespace

ZeroResult FindZero(absl::FunctionRef<absl::StatusOr<double>(double)> function, ZeroBracket bracket,
                    double tolerance) {
  // `a` is the newest point, `b` the end across the zero.
  double a = bracket.a, b = bracket.b, fa = bracket.value_a, fb = bracket.value_b;
  double fraction = 0.5;
  const auto result = [&](bool complete) {
    return ZeroResult{.bracket = {.a = a, .b = b, .value_a = fa, .value_b = fb},
                      .complete = complete};
  };
  for (int i = 0; i < kMostEvaluations; ++i) {
    const double width = std::abs(b - a);
    const double least = std::max(
        tolerance, std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b)));
    if (width <= least || fa == 0 || fb == 0) return result(true);
    // At least half a tolerance from either end, so that the bracket closes from both sides.
    const double margin = std::min(0.5, 0.5 * least / width);
    fraction = std::clamp(fraction, margin, 1 - margin);
    const double x = a + fraction * (b - a);
    const absl::StatusOr<double> value = function(x);
    if (!value.ok()) return result(false);
    double c = a, fc = fa;
    if (!Same(*value, fa)) {
      c = b, fc = fb;
      b = a, fb = fa;
    }
    a = x, fa = *value;
    fraction = NextFraction(a, b, c, fa, fb, fc);
  }
  return result(false);
}

}  // namespace celt
