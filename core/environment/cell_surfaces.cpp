#include "environment/cell_surfaces.h"

#include <algorithm>
#include <limits>

namespace boomwatch {
namespace {

using Eigen::Vector3f;

constexpr std::uint32_t outside = std::numeric_limits<std::uint32_t>::max();

std::uint32_t cellOf(const Vector3f& point, const GridGeometry& geometry) {
  const double toPlane = geometry.toPlane(point.z());
  const double row = geometry.rowPosition(point.y() * toPlane);
  const double column = geometry.columnPosition(point.x() * toPlane);
  if (!geometry.covers(column, row)) return outside;
  return static_cast<std::uint32_t>(
      geometry.index(static_cast<int>(column), static_cast<int>(row)));
}

/// The point of the same cell that lies at depth z.
Vector3f movedTo(float z, const Vector3f& point, const GridGeometry& geometry) {
  if (!geometry.isPerspective()) return {point.x(), point.y(), z};
  const Vector3f moved = point * (z / point.z());
  // Rays spread: at the sides one may leave the bounds, and would show that nothing is there.
  return geometry.bounds().contains(moved) ? moved : point;
}

}  // namespace

Points CellSurfaces::of(std::span<const Vector3f> points, const GridGeometry& geometry) {
  m_cells.resize(geometry.cellCount());
  m_cellOf.clear();
  for (const Vector3f& p : points) {
    m_cellOf.push_back(cellOf(p, geometry));
    if (m_cellOf.back() == outside) continue;
    Seen& seen = m_cells[m_cellOf.back()];
    seen.nearest = seen.count == 0 ? p.z() : std::min(seen.nearest, p.z());
    seen.count = 1;
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (m_cellOf[k] == outside) continue;
    Seen& seen = m_cells[m_cellOf[k]];
    const float behind = points[k].z() - seen.nearest;
    if (behind == 0.0F || behind > static_cast<float>(2.0 * geometry.cellSize(seen.nearest))) {
      continue;
    }
    seen.behind += behind;
    ++seen.count;
  }
  Points surfaces;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (m_cellOf[k] == outside) continue;
    Seen& seen = m_cells[m_cellOf[k]];
    if (seen.count == 0) continue;
    const auto most = static_cast<float>(geometry.cellSize(seen.nearest));
    const float mean = seen.behind / static_cast<float>(seen.count);
    surfaces.push_back(movedTo(seen.nearest + std::min(mean, most), points[k], geometry));
    seen = {};
  }
  return surfaces;
}

}  // namespace boomwatch
