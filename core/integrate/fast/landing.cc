#include "core/integrate/fast/landing.h"

#include <cmath>

namespace celt::fast {
namespace {

constexpr int kPoints = static_cast<int>(kInterpolated.size());
using Table = std::array<std::array<double, kPoints>, kPoints>;

/// Entry (k, j): coefficient of θ^(k+1) in the integral from 0 to θ of the Lagrange polynomial of
/// node j.
constexpr Table IntegratedLagrange() {
  Table table{};
  for (int j = 0; j < kPoints; ++j) {
    std::array<double, kPoints> product{1};
    for (int i = 0, degree = 0; i < kPoints; ++i) {
      if (i == j) continue;
      const double node = kNodes[kInterpolated[i]];
      const double scale = 1 / (kNodes[kInterpolated[j]] - node);
      ++degree;
      for (int k = degree; k >= 0; --k) {
        product[k] = scale * ((k > 0 ? product[k - 1] : 0) - node * product[k]);
      }
    }
    for (int k = 0; k < kPoints; ++k) table[k][j] = product[k] / (k + 1);
  }
  return table;
}

constexpr Table kTable = IntegratedLagrange();
constexpr int kMostValues = 8;

/// The part at value 0 of the polynomial through (value, part), by Neville's scheme.
double InverseInterpolate(const std::array<PartValue, kMostValues>& points, int count) {
  std::array<double, kMostValues> part{};
  for (int i = 0; i < count; ++i) {
    part[i] = points[i].part;
    for (int k = i - 1; k >= 0; --k) {
      part[k] = (points[i].value * part[k] - points[k].value * part[k + 1]) /
                (points[i].value - points[k].value);
    }
  }
  return part[0];
}

}  // namespace

std::array<double, kInterpolated.size()> PartWeights(double part) {
  std::array<double, kPoints> weights = kTable[kPoints - 1];
  for (int k = kPoints - 2; k >= 0; --k) {
    for (int j = 0; j < kPoints; ++j) weights[j] = weights[j] * part + kTable[k][j];
  }
  for (double& weight : weights) weight *= part;
  return weights;
}

double FindCrossing(PartValue low, PartValue high, PartValue other,
                    absl::FunctionRef<double(double)> value) {
  // The next guess is a hundred times closer than the last two are to each other.
  constexpr double kClose = 1e-3;
  std::array<PartValue, kMostValues> points{low, high, other};
  double part = low.part;
  for (int count = 3;; ++count) {
    const double previous = part;
    part = InverseInterpolate(points, count);
    if (!(part > low.part && part < high.part)) {
      part = low.part + (high.part - low.part) * low.value / (low.value - high.value);
    }
    if (std::abs(part - previous) < kClose || count == kMostValues) return part;
    points[count] = {part, value(part)};
    ((points[count].value < 0) == (low.value < 0) ? low : high) = points[count];
  }
}

}  // namespace celt::fast
