#include "core/analysis/lmp_graph.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/analysis/cell_grid.h"
#include "core/analysis/line_angle.h"

namespace celt {
namespace {

constexpr double kLeastCell = 0x1p-12;
constexpr double kLargestCell = 0x1p+4;

/// A finaliser of bits (Steele, Lea & Flood 2014): a number as if drawn for each argument.
std::uint64_t Scramble(std::uint64_t z) {
  z += 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return z ^ (z >> 31U);
}

/// Bins that are being filled.
class Filling {
 public:
  Filling(std::span<const LmpPoint> points, const LmpOptions& options)
      : points_(points), options_(options) {
    const double decades = std::log10(options.largest_distance / options.least_distance);
    const int count = static_cast<int>(std::ceil(decades * options.bins_per_decade)) + 1;
    double from = 0;
    for (int i = 0; i < count; ++i) {
      LmpBin bin;
      bin.from = from;
      bin.to =
          options.least_distance * std::pow(10.0, static_cast<double>(i) / options.bins_per_decade);
      from = bin.to;
      bins_.push_back(std::move(bin));
    }
    ranks_.resize(bins_.size());
  }

  void Add(std::int64_t i, std::int64_t j, double distance) {
    const std::size_t at = BinOf(distance);
    if (at >= bins_.size()) return;
    const LmpPoint& a = points_[std::min(i, j)];
    const LmpPoint& b = points_[std::max(i, j)];
    const LmpPair pair = {distance, AngleOfLines(a.e, b.e), a.iterate, b.iterate};
    LmpBin& bin = bins_[at];
    if (bin.pairs++ == 0 || Wider(pair, bin.widest)) bin.widest = pair;
    Draw(pair, bin.sample, ranks_[at]);
  }

  /// `complete_below`: every pair closer than this was added.
  std::vector<LmpBin> Take(double complete_below) && {
    for (LmpBin& bin : bins_) {
      bin.complete = bin.to <= complete_below;
      std::sort(bin.sample.begin(), bin.sample.end(), [](const LmpPair& a, const LmpPair& b) {
        return std::pair(a.first, a.second) < std::pair(b.first, b.second);
      });
    }
    return std::move(bins_);
  }

 private:
  std::size_t BinOf(double distance) const {
    const auto above =
        std::upper_bound(bins_.begin(), bins_.end(), distance,
                         [](double wanted, const LmpBin& bin) { return wanted < bin.to; });
    return static_cast<std::size_t>(above - bins_.begin());
  }

  /// Ties by iterates: what comes first must not depend on how pairs were found.
  static bool Wider(const LmpPair& a, const LmpPair& b) {
    if (a.angle != b.angle) return a.angle > b.angle;
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  }

  /// Keeps the pairs of lowest rank; `ranks` runs beside `sample`.
  void Draw(const LmpPair& pair, std::vector<LmpPair>& sample,
            std::vector<std::uint64_t>& ranks) const {
    const std::uint64_t rank = Scramble(Scramble(static_cast<std::uint64_t>(pair.first)) ^
                                        static_cast<std::uint64_t>(pair.second));
    if (std::ssize(sample) < options_.sample) {
      sample.push_back(pair);
      ranks.push_back(rank);
      return;
    }
    const auto worst = std::max_element(ranks.begin(), ranks.end());
    if (worst == ranks.end() || *worst <= rank) return;
    sample[worst - ranks.begin()] = pair;
    *worst = rank;
  }

  std::span<const LmpPoint> points_;
  LmpOptions options_;
  std::vector<LmpBin> bins_;
  std::vector<std::vector<std::uint64_t>> ranks_;
};

struct Search {
  std::vector<LmpPoint> points;
  std::vector<Point> positions;
  double cell = kLargestCell;
};

/// Halves the cells, and then the number of points, until the near pairs are few enough.
Search PlanSearch(std::span<const LmpPoint> given, std::int64_t most_pairs) {
  Search search;
  search.points.assign(given.begin(), given.end());
  for (const LmpPoint& point : given) search.positions.push_back(point.x);
  while (CellGrid(search.positions, search.cell).CandidatePairs() > most_pairs) {
    if (search.cell > kLeastCell) {
      search.cell /= 2;
      continue;
    }
    for (std::size_t i = 0; 2 * i < search.points.size(); ++i) {
      search.points[i] = search.points[2 * i];
      search.positions[i] = search.positions[2 * i];
    }
    const std::size_t half = (search.points.size() + 1) / 2;
    search.points.resize(half);
    search.positions.resize(half);
  }
  return search;
}

}  // namespace

std::vector<LmpBin> LmpGraph(std::span<const LmpPoint> points, const LmpOptions& options) {
  const Search search = PlanSearch(points, options.most_near_pairs);
  const std::vector<Point>& x = search.positions;
  Filling filling(search.points, options);
  const auto distance = [&x](std::int64_t i, std::int64_t j) { return (x[i] - x[j]).norm(); };
  CellGrid(x, search.cell).ForEachPair([&](std::int64_t i, std::int64_t j) {
    if (const double rho = distance(i, j); rho < search.cell) filling.Add(i, j, rho);
  });
  const std::uint64_t count = x.size();
  for (std::int64_t k = 0; k < options.far_pairs && count > 1; ++k) {
    const auto i = static_cast<std::int64_t>(Scramble(2 * static_cast<std::uint64_t>(k)) % count);
    const auto j =
        static_cast<std::int64_t>(Scramble(2 * static_cast<std::uint64_t>(k) + 1) % count);
    if (const double rho = distance(i, j); i != j && rho >= search.cell) filling.Add(i, j, rho);
  }
  return std::move(filling).Take(search.cell);
}

LmpNear NearestPairs(std::span<const LmpBin> bins, double distance) {
  constexpr double kRounding = 1e-9;  // an edge of a bin is not to be missed by its last digit
  LmpNear near;
  for (const LmpBin& bin : bins) {
    if (bin.to > distance * (1 + kRounding) || bin.pairs == 0) continue;
    if (near.pairs == 0 || bin.widest.angle > near.widest.angle) near.widest = bin.widest;
    near.pairs += bin.pairs;
  }
  return near;
}

}  // namespace celt
