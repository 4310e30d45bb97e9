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
/// Depth level 0 means "no measurement"; levels 1..255 mean z = zMin + level (zMax - zMin) / 255.
class GridGeometry {
 public:
  static constexpr double bytesPerCell = 5.0;  ///< float probability and 8-bit level
  static constexpr int levels = 255;

  GridGeometry() : GridGeometry(Bounds{}, 0.04) {}
  GridGeometry(const Bounds& bounds, double resolution)
      : m_bounds(bounds),
        m_resolution(resolution),
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

  int columnOf(double x) const {
    return static_cast<int>(std::floor((x - m_bounds.xMin) / m_resolution));
  }
  int rowOf(double y) const {
    return static_cast<int>(std::floor((y - m_bounds.yMin) / m_resolution));
  }
  /// The nearest level, at least 1: what is measured is never level 0.
  std::uint8_t levelOf(double z) const {
    return static_cast<std::uint8_t>(
        std::clamp(std::lround((z - m_bounds.zMin) / levelStep()), 1L, 255L));
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
  /// Eq. 6: floor(w / R); the small addend keeps 20 / 0.04 from becoming 499.
  static int cells(double width, double resolution) {
    return static_cast<int>(std::floor(width / resolution + 1e-9));
  }

  Bounds m_bounds;
  double m_resolution;
  int m_columns;
  int m_rows;
};

}  // namespace boomwatch
