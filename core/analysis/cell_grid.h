#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "absl/functional/function_ref.h"
#include "core/map/map.h"

namespace celt {

/// Points sorted into cubic cells by their first three coordinates (or as many as there are), to
/// find close pairs without looking at all.
class CellGrid {
 public:
  /// `size` > 0. Coordinates beyond 2²⁰ cells from 0 go to the outermost cell.
  CellGrid(std::span<const Point> points, double size);

  /// Pairs in the same cell or in neighbouring ones, about: what ForEachPair will look at.
  std::int64_t CandidatePairs() const;

  /// Calls with each pair i ≠ j, once, in the same cell or in cells that touch: among them all
  /// pairs closer than `size`.
  void ForEachPair(absl::FunctionRef<void(std::int64_t i, std::int64_t j)> visit) const;

 private:
  struct Cell {
    std::uint64_t key;
    std::int64_t begin;
    std::int64_t end;
  };

  const Cell* Find(std::uint64_t key) const;

  std::vector<std::int64_t> order_;  ///< indices of points, cell by cell
  std::vector<Cell> cells_;          ///< by key
};

}  // namespace celt
