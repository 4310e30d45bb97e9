#include "environment/depth_view.h"

#include <cmath>

namespace boomwatch {

bool DepthView::looksThrough(const Eigen::Vector3d& surface, double size, double room) const {
  if (!m_projection || !(surface.z() > 0.0)) return false;
  static constexpr int places[5][2] = {{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
  for (const auto& [right, down] : places) {
    const Eigen::Vector2d pixel =
        (*m_projection)(surface + Eigen::Vector3d(right, down, 0) * (size / 4));
    const double column = std::round(pixel.x()), row = std::round(pixel.y());
    if (!(column >= 0 && column < m_cloud.width && row >= 0 && row < m_cloud.height)) return false;
    const Eigen::Vector3f& seen = m_cloud.at(static_cast<int>(column), static_cast<int>(row));
    if (!(static_cast<double>(seen.z()) > surface.z() + room)) return false;  // nor if it is NaN
  }
  return true;
}

}  // namespace boomwatch
