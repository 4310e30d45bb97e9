#include "environment/depth_view.h"

namespace boomwatch {

const Eigen::Vector3f* DepthView::seenTowards(const Eigen::Vector3d& point) const {
  if (!m_cloud.camera || !(point.z() > 0.0)) return nullptr;
  const Eigen::Vector2d pixel = m_cloud.camera->project(point).array().round();
  if (!m_cloud.camera->contains(pixel)) return nullptr;
  return &m_cloud.at(static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
}

bool DepthView::looksThrough(const Eigen::Vector3d& surface, double size, double room) const {
  static constexpr int places[5][2] = {{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
  for (const auto& [right, down] : places) {
    const auto* seen = seenTowards(surface + Eigen::Vector3d(right, down, 0) * (size / 4));
    // Written so that a NaN gives false.
    if (!seen || !(static_cast<double>(seen->z()) > surface.z() + room)) return false;
  }
  return true;
}

bool DepthView::hides(const Eigen::Vector3d& surface, double room) const {
  const Eigen::Vector3f* seen = seenTowards(surface);
  return seen && static_cast<double>(seen->z()) < surface.z() - room;
}

}  // namespace boomwatch
