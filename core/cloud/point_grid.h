#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frame/cloud.h"

namespace boomwatch {

/// Points sorted into cubes, in rows along x: neighbouring cubes lie close together in memory, and
/// a sweep over the rows meets all of them without a search. A row is two cubes wide and two deep:
/// what lies at most two cubes away lies in the same row or in one of the eight around it.
///
/// Takes memory by the number of points, whatever space they span.
struct PointGrid {
  /// Points [begin, end) of `points` lie in one cube.
  struct Cell {
    std::uint32_t place;  ///< 4 x + 2 (z mod 2) + (y mod 2), from 8 up
    std::uint32_t begin;
    std::uint32_t end;
  };
  /// Cells [begin, end), in order of place. Rows are in order of `key`.
  struct Row {
    std::uint64_t key;  ///< (z / 2) * rowsPerLayer + y / 2
    std::uint32_t begin;
    std::uint32_t end;
  };
  Points points;                     ///< in the order of the cells
  std::vector<std::uint32_t> order;  ///< where each of `points` was in the input
  std::vector<Cell> cells;
  std::vector<Row> rows;
  /// A row at each end of a layer is left empty: one step in y never leaves it.
  std::uint64_t rowsPerLayer = 0;
};

/// Cubes of `side` metres; points that are not finite are left out. Coordinates more than two cells
/// apart stay so, those up to two cells apart keep their difference; wider gaps may shrink where
/// the points span more than 2^29 cells.
PointGrid sortIntoCells(std::span<const Eigen::Vector3f> points, double side);

}  // namespace boomwatch
