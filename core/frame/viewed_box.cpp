#include "frame/viewed_box.h"

#include <algorithm>

namespace boomwatch {

bool ViewedBox::contains(const Eigen::Vector3d& p) const {
  if (!(p.z() > 0.0)) return box.contains(p);
  constexpr double nearlyAtInfinity = 0.01;
  // Where on its line of sight the point may be, as multiples of itself.
  double least = 1.0 / (1.0 + p.z() * behind);
  double most = 1.0 / std::max(nearlyAtInfinity, 1.0 - p.z() * before);
  const Eigen::Vector3d sight = box.rotation.transpose() * p;
  const Eigen::Vector3d centre = box.rotation.transpose() * box.centre;
  for (int k = 0; k < 3; ++k) {
    const double half = box.size[k] / 2;
    if (sight[k] == 0.0) {
      if (std::abs(centre[k]) > half) return false;
      continue;
    }
    const double a = (centre[k] - half) / sight[k], b = (centre[k] + half) / sight[k];
    least = std::max(least, std::min(a, b));
    most = std::min(most, std::max(a, b));
  }
  return least <= most;
}

}  // namespace boomwatch
