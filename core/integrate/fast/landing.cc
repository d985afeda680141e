#include "core/integrate/fast/landing.h"

#include <cmath>
#include <cstddef>

#include "core/integrate/fast/lagrange.h"

namespace celt::fast {
namespace {

constexpr LagrangeTable<double, kInterpolated.size()> MakeTable() {
  std::array<double, kInterpolated.size()> nodes{};
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = kNodes[kInterpolated[i]];
  return IntegratedLagrange(nodes);
}

constexpr auto kTable = MakeTable();
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
  return IntegralWeights(kTable, part);
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
