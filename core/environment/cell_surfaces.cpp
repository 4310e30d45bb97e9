#include "environment/cell_surfaces.h"

#include <algorithm>
#include <limits>

namespace boomwatch {
namespace {

using Eigen::Vector3f;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The point moved to depth z inside its cell.
Vector3f movedTo(float z, const Vector3f& point, const GridGeometry& geometry) {
  if (!geometry.isPerspective()) return {point.x(), point.y(), z};
  const Vector3f moved = point * (z / point.z());
  // Rays diverge. A point that left the bounds at the side would show free space.
  return geometry.bounds().contains(moved) ? moved : point;
}

}  // namespace

Points CellSurfaces::extract(std::span<const Vector3f> points, const GridGeometry& geometry) {
  m_seenOfCell.resize(geometry.cellCount(), none);
  m_seenOfPoint.clear();
  m_seen.clear();
  for (const Vector3f& p : points) note(p, geometry);
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (m_seenOfPoint[k] == none) continue;
    Seen& seen = m_seen[m_seenOfPoint[k]];
    const float behind = points[k].z() - seen.nearest;
    if (behind == 0.0F || behind > static_cast<float>(2.0 * geometry.cellSize(seen.nearest))) {
      continue;
    }
    seen.behind += behind;
    ++seen.count;
  }
  Points surfaces;
  surfaces.reserve(m_seen.size());
  for (const Seen& seen : m_seen) {
    const auto most = static_cast<float>(geometry.cellSize(seen.nearest));
    const float mean = seen.behind / static_cast<float>(seen.count);
    surfaces.push_back(movedTo(seen.nearest + std::min(mean, most), seen.first, geometry));
    m_seenOfCell[seen.cell] = none;
  }
  return surfaces;
}

void CellSurfaces::note(const Vector3f& point, const GridGeometry& geometry) {
  m_seenOfPoint.push_back(none);
  const auto cell = geometry.indexAt(point);
  if (!cell) return;
  if (m_seenOfCell[*cell] == none) {
    m_seenOfCell[*cell] = static_cast<std::uint32_t>(m_seen.size());
    m_seen.push_back({*cell, point, point.z()});
  }
  m_seenOfPoint.back() = m_seenOfCell[*cell];
  Seen& seen = m_seen[m_seenOfPoint.back()];
  seen.nearest = std::min(seen.nearest, point.z());
}

}  // namespace boomwatch
