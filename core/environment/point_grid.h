#pragma once

#include <cstdint>
#include <vector>

#include "frame/cloud.h"

namespace boomwatch {

/// Points sorted into cubes, in rows along x: neighbouring cubes lie close together in memory, and
/// a sweep over the rows meets all of them without a search.
///
/// Takes memory by the number of points, whatever space they span. Points must be finite.
struct PointGrid {
  /// Points [begin, end) of `points` lie in one cube.
  struct Cell {
    std::uint32_t x;
    std::uint32_t begin;
    std::uint32_t end;
  };
  /// Cells [begin, end), in order of x, have the same y and z. Rows are in order of `key`.
  struct Row {
    std::uint64_t key;  ///< z * rowsPerLayer + y
    std::uint32_t begin;
    std::uint32_t end;
  };
  Points points;                     ///< in the order of the cells
  std::vector<std::uint32_t> order;  ///< where each of `points` was in the input
  std::vector<Cell> cells;
  std::vector<Row> rows;
  /// Two rows at each end of a layer are left empty: up to two steps in y never leave it.
  std::uint64_t rowsPerLayer = 0;
};

/// Cubes of `side` metres. Coordinates more than two cells apart stay so, those up to two cells
/// apart keep their difference; wider gaps may shrink where the points span more than 2^31 cells.
PointGrid sortIntoCells(const Points& points, double side);

}  // namespace boomwatch
