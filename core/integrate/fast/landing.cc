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

/// The part where e vanishes, between `low` and `high`.
double Zero(const Look& low, const Look& high, const Look& other,
            absl::FunctionRef<Look(double)> look) {
  return FindCrossing({low.part, low.value}, {high.part, high.value}, {other.part, other.value},
                      [look](double part) { return look(part).value; });
}

/// Where e has one sign at both ends, its side two: the sign of e where the side changes tells.
std::optional<double> CrossingOfTwo(const Look& low, const Look& high, const Look& other,
                                    absl::FunctionRef<Look(double)> look) {
  const Look turn =
      look(FindCrossing({low.part, low.side}, {high.part, high.side}, {other.part, other.side},
                        [look](double part) { return look(part).side; }));
  if (turn.value < 0 && low.value > 0 && high.side > 0) return Zero(turn, high, low, look);
  if (turn.value > 0 && low.value < 0 && low.side > 0) return Zero(low, turn, high, look);
  return std::nullopt;
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

std::optional<double> CrossingPart(const Look& low, const Look& high, const Look& other,
                                   absl::FunctionRef<Look(double)> look) {
  if (low.value < 0 && high.value >= 0) {
    if (!(low.side > 0 || high.side > 0)) return std::nullopt;
    const double part = Zero(low, high, other, look);
    if ((low.side > 0 && high.side > 0) || look(part).side > 0) return part;
    return std::nullopt;
  }
  // Past |L/G| = 1 or |H/G| = 1, (e, side) goes past 0 quickly, and e may change its sign twice.
  const bool passes = low.value * high.value > 0 && low.side * high.side < 0 &&
                      std::abs(low.value) < std::abs(low.side - high.side);
  return passes ? CrossingOfTwo(low, high, other, look) : std::nullopt;
}

}  // namespace celt::fast
