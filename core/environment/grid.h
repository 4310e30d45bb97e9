#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "frame/bounds.h"

namespace boomwatch {

/// How metres and cells belong together (method.md section 6, Eq. 6, 10-11 with the errata).
///
/// Column i grows with x, row j with y; cell (i, j) covers [xMin + iR, xMin + (i+1)R) and so on.
/// What lies on an edge, to a billionth of a cell, belongs to the cell that begins there. Depth
/// level 0 means "no measurement"; levels 1..255 mean z = zMin + level (zMax - zMin) / 255.
class GridGeometry {
 public:
  static constexpr double bytesPerCell = 5.0;  ///< float probability and 8-bit level
  static constexpr int levels = 255;

  GridGeometry() : GridGeometry(Bounds{}, 0.04) {}
  GridGeometry(const Bounds& bounds, double resolution)
      : m_bounds(bounds),
        m_resolution(resolution),
        m_cellsPerMetre(1.0 / resolution),
        m_levelsPerMetre(levels / (bounds.zMax - bounds.zMin)),
        m_columns(cells(bounds.xMax - bounds.xMin, resolution)),
        m_rows(cells(bounds.yMax - bounds.yMin, resolution)) {}

  const Bounds& bounds() const { return m_bounds; }
  double resolution() const { return m_resolution; }
  int columns() const { return m_columns; }
  int rows() const { return m_rows; }
  std::size_t cellCount() const {
    return static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows);
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) +
           static_cast<std::size_t>(column);
  }
  bool contains(int column, int row) const {
    return column >= 0 && column < m_columns && row >= 0 && row < m_rows;
  }
  /// Metres a depth level is deep.
  double levelStep() const { return (m_bounds.zMax - m_bounds.zMin) / levels; }

  /// Where a coordinate lies in cells: its whole part is the column, or the row. Not rounded, so
  /// that a hot loop can compare before it converts.
  double columnPosition(double x) const { return (x - m_bounds.xMin) * m_cellsPerMetre + onEdge; }
  double rowPosition(double y) const { return (y - m_bounds.yMin) * m_cellsPerMetre + onEdge; }
  /// Any number will do; one far outside the bounds (or NaN) gives a column far outside.
  int columnOf(double x) const { return whole(columnPosition(x)); }
  int rowOf(double y) const { return whole(rowPosition(y)); }
  /// The nearest level, at least 1: what is measured is never level 0.
  std::uint8_t levelOf(double z) const {
    const double level = (z - m_bounds.zMin) * m_levelsPerMetre + 0.5;
    return static_cast<std::uint8_t>(static_cast<int>(within(level, 1.0, 255.0)));
  }
  double xOf(int column) const { return m_bounds.xMin + (column + 0.5) * m_resolution; }
  double yOf(int row) const { return m_bounds.yMin + (row + 0.5) * m_resolution; }
  double zOf(int level) const { return m_bounds.zMin + level * levelStep(); }
  /// Centre of the surface of a cell whose depth level is `level`. Camera frame, metres.
  Eigen::Vector3d surfacePoint(int column, int row, int level) const {
    return {xOf(column), yOf(row), zOf(level)};
  }

  bool operator==(const GridGeometry&) const = default;

 private:
  /// Keeps 20 / 0.04 from becoming 499, and a point on an edge in the cell that begins there.
  static constexpr double onEdge = 1e-9;

  /// What does not fit must not be converted; a NaN gives `low`. (fmin and fmax are calls.)
  static double within(double value, double low, double high) {
    return value > low ? (value < high ? value : high) : low;
  }
  static int whole(double position) {
    return static_cast<int>(within(std::floor(position), -1e9, 1e9));
  }
  /// Eq. 6: floor(w / R).
  static int cells(double width, double resolution) {
    return std::max(0, whole(width / resolution + onEdge));
  }

  Bounds m_bounds;
  double m_resolution;
  double m_cellsPerMetre;
  double m_levelsPerMetre;
  int m_columns;
  int m_rows;
};

}  // namespace boomwatch
