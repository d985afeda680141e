#include "core/analysis/cell_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace celt {
namespace {

constexpr int kBits = 21;  // of a cell's number along each of three axes
constexpr double kHalfRange = (1 << (kBits - 1)) - 2;

std::uint64_t KeyOf(const Point& x, double size) {
  std::uint64_t key = 0;
  for (Eigen::Index i = 0; i < std::min<Eigen::Index>(x.size(), 3); ++i) {
    const double cell = std::clamp(std::floor(x[i] / size), -kHalfRange, kHalfRange);
    key |= static_cast<std::uint64_t>(cell + kHalfRange + 1) << (kBits * i);
  }
  return key;
}

/// Half of the 26 neighbours, as differences of keys: the other half sees the cell from its side.
/// No axis over- or underflows into the next, for cell numbers keep off 0 and 2^kBits − 1.
std::array<std::uint64_t, 13> HalfOfNeighbours() {
  std::array<std::uint64_t, 13> offsets{};
  constexpr std::int64_t kY = std::int64_t{1} << kBits;
  constexpr std::int64_t kZ = std::int64_t{1} << (2 * kBits);
  std::size_t count = 0;
  for (std::int64_t offset = 14; offset < 27; ++offset) {
    const std::int64_t step = (offset % 3 - 1) + (offset / 3 % 3 - 1) * kY + (offset / 9 - 1) * kZ;
    offsets[count++] = static_cast<std::uint64_t>(step);
  }
  return offsets;
}

}  // namespace

CellGrid::CellGrid(std::span<const Point> points, double size) : order_(points.size()) {
  std::vector<std::uint64_t> keys;
  for (const Point& x : points) keys.push_back(KeyOf(x, size));
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&keys](std::int64_t a, std::int64_t b) {
    return keys[a] != keys[b] ? keys[a] < keys[b] : a < b;
  });
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(order_.size()); ++i) {
    const std::uint64_t key = keys[order_[i]];
    if (cells_.empty() || cells_.back().key != key) cells_.push_back({key, i, i});
    cells_.back().end = i + 1;
  }
}

const CellGrid::Cell* CellGrid::Find(std::uint64_t key) const {
  const auto at =
      std::lower_bound(cells_.begin(), cells_.end(), key,
                       [](const Cell& cell, std::uint64_t wanted) { return cell.key < wanted; });
  return at != cells_.end() && at->key == key ? &*at : nullptr;
}

std::int64_t CellGrid::CandidatePairs() const {
  std::int64_t pairs = 0;
  for (const Cell& cell : cells_) {
    const std::int64_t count = cell.end - cell.begin;
    pairs += count * (count - 1) / 2;
    for (const std::uint64_t offset : HalfOfNeighbours()) {
      const Cell* other = Find(cell.key + offset);
      if (other != nullptr) pairs += count * (other->end - other->begin);
    }
  }
  return pairs;
}

void CellGrid::ForEachPair(absl::FunctionRef<void(std::int64_t, std::int64_t)> visit) const {
  for (const Cell& cell : cells_) {
    for (std::int64_t a = cell.begin; a < cell.end; ++a) {
      for (std::int64_t b = a + 1; b < cell.end; ++b) visit(order_[a], order_[b]);
    }
    for (const std::uint64_t offset : HalfOfNeighbours()) {
      const Cell* other = Find(cell.key + offset);
      if (other == nullptr) continue;
      for (std::int64_t a = cell.begin; a < cell.end; ++a) {
        for (std::int64_t b = other->begin; b < other->end; ++b) visit(order_[a], order_[b]);
      }
    }
  }
}

}  // namespace celt
