#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "frame/bounds.h"
#include "parameters/model_projection.h"

namespace boomwatch {

/// Converts between metres and cells (docs/method.md section 6, Eq. 6, 10-11 with the errata).
///
/// Column i grows with x, row j with y; cell (i, j) covers [left + iR, left + (i+1)R) of the
/// model's plane, and likewise in rows. A point on an edge, to a billionth of a cell, belongs to
/// the cell that begins there. Depth level 0 means "no measurement"; levels 1..255 mean z = zMin +
/// level (zMax - zMin) / 255.
///
/// Parallel: the plane is x-y, and `left` is xMin. Perspective: the plane lies at half of zMax, and
/// points are projected to it along their rays, x zMax/2 / z. It covers the bounds, up to 56
/// degrees from the axis on each side. R is a cell's side on the plane; a cell grows with z.
class GridGeometry {
 public:
  static constexpr double bytesPerCell = 5.0;  ///< float probability and 8-bit level
  static constexpr int levels = 255;

  /// The part of the model's plane that cells cover, metres.
  struct Plane {
    double left, right, top, bottom;
    bool operator==(const Plane&) const = default;
  };

  static Plane planeOf(const Bounds& b, ModelProjection projection) {
    if (projection == ModelProjection::Parallel) return {b.xMin, b.xMax, b.yMin, b.yMax};
    constexpr double maxTangent = 1.5;  // of the angle to the axis
    // A ray that meets [low, high] anywhere between zMin and zMax has a tangent between these.
    const auto tangent = [&](double side, bool outwards) {
      const double z = outwards ? std::max(b.zMin, 1e-3) : b.zMax;
      return within(side / z, -maxTangent, maxTangent) * b.zMax / 2;
    };
    return {tangent(b.xMin, b.xMin < 0.0), tangent(b.xMax, b.xMax > 0.0),
            tangent(b.yMin, b.yMin < 0.0), tangent(b.yMax, b.yMax > 0.0)};
  }

  GridGeometry() : GridGeometry(Bounds{}, 0.04) {}
  GridGeometry(const Bounds& bounds, double resolution,
               ModelProjection projection = ModelProjection::Parallel)
      : m_bounds(bounds),
        m_plane(planeOf(bounds, projection)),
        m_planeZ(projection == ModelProjection::Perspective ? bounds.zMax / 2 : 0.0),
        m_resolution(resolution),
        m_cellsPerMetre(1.0 / resolution),
        m_levelsPerMetre(levels / (bounds.zMax - bounds.zMin)),
        m_columns(cells(m_plane.right - m_plane.left, resolution)),
        m_rows(cells(m_plane.bottom - m_plane.top, resolution)) {}

  const Bounds& bounds() const { return m_bounds; }
  const Plane& plane() const { return m_plane; }
  bool isPerspective() const { return m_planeZ > 0.0; }
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
  /// Metres between two depth levels.
  double levelStep() const { return (m_bounds.zMax - m_bounds.zMin) / levels; }

  /// Factor from x and y at depth z (above 0 in perspective) to the model's plane.
  double toPlane(double z) const { return isPerspective() ? m_planeZ / z : 1.0; }
  /// Camera frame to the model's plane, metres.
  Eigen::Vector2d onPlane(const Eigen::Vector3d& p) const { return p.head<2>() * toPlane(p.z()); }

  /// Position of a plane coordinate in cells; the integer part is the column, or the row. Not
  /// rounded, so that a hot loop can compare before it converts.
  double columnPosition(double x) const { return (x - m_plane.left) * m_cellsPerMetre + onEdge; }
  double rowPosition(double y) const { return (y - m_plane.top) * m_cellsPerMetre + onEdge; }
  /// Whether a position in cells lies in the grid, and so fits an integer; a NaN does not.
  bool covers(double columnPosition, double rowPosition) const {
    return rowPosition >= 0.0 && rowPosition < m_rows && columnPosition >= 0.0 &&
           columnPosition < m_columns;
  }
  /// Accepts any number: one far outside the bounds, or a NaN, gives a column outside the grid.
  int columnOf(double x) const { return whole(columnPosition(x)); }
  int rowOf(double y) const { return whole(rowPosition(y)); }
  /// The cell of a point (camera frame). Absent outside the grid, and for a NaN.
  std::optional<std::size_t> indexAt(const Eigen::Vector3f& p) const {
    const double scale = toPlane(p.z());
    const double column = columnPosition(p.x() * scale), row = rowPosition(p.y() * scale);
    if (!covers(column, row)) return std::nullopt;
    return index(static_cast<int>(column), static_cast<int>(row));
  }
  /// The nearest level, at least 1, because level 0 means no measurement.
  std::uint8_t levelOf(double z) const {
    const double level = (z - m_bounds.zMin) * m_levelsPerMetre + 0.5;
    return static_cast<std::uint8_t>(static_cast<int>(within(level, 1.0, 255.0)));
  }
  /// Centre of a cell on the plane.
  double xOf(int column) const { return m_plane.left + (column + 0.5) * m_resolution; }
  double yOf(int row) const { return m_plane.top + (row + 0.5) * m_resolution; }
  double zOf(int level) const { return m_bounds.zMin + level * levelStep(); }
  /// Centre of the surface of a cell at depth `level`. Camera frame, metres.
  Eigen::Vector3d surfacePoint(int column, int row, int level) const {
    const double z = zOf(level);
    const double fromPlane = 1.0 / toPlane(z);
    return {xOf(column) * fromPlane, yOf(row) * fromPlane, z};
  }
  Eigen::Vector3d surfacePoint(std::size_t index, int level) const {
    const auto columns = static_cast<std::size_t>(m_columns);
    return surfacePoint(static_cast<int>(index % columns), static_cast<int>(index / columns),
                        level);
  }
  /// Width and height of a cell at depth z, metres.
  double cellSize(double z) const { return m_resolution / toPlane(z); }
  /// Size of a cell and a depth level along x, y and z around a surface point, metres.
  Eigen::Vector3d cellExtent(const Eigen::Vector3d& surface) const {
    Eigen::Vector3d extent(cellSize(surface.z()), cellSize(surface.z()), levelStep());
    if (isPerspective()) {
      extent.head<2>() += surface.head<2>().cwiseAbs() * (levelStep() / surface.z());
    }
    return extent;
  }

  bool operator==(const GridGeometry&) const = default;

 private:
  /// Keeps 20 / 0.04 from becoming 499, and a point on an edge in the cell that begins there.
  static constexpr double onEdge = 1e-9;

  /// Clamps before a conversion to an integer; a NaN gives `low`. (fmin and fmax are slow calls.)
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
  Plane m_plane;
  double m_planeZ;  ///< 0: parallel
  double m_resolution;
  double m_cellsPerMetre;
  double m_levelsPerMetre;
  int m_columns;
  int m_rows;
};

}  // namespace boomwatch
