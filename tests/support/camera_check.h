#pragma once

#include <algorithm>
#include <limits>

#include "frame/cloud.h"

/// How far, in pixels, the camera of a cloud puts a measured point from the pixel that measured it,
/// at most. Infinite where the camera is absent or of another size, or nothing was measured.
inline double missOfCamera(const boomwatch::Cloud& cloud) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto& camera = cloud.camera;
  if (!camera || camera->width != cloud.width || camera->height != cloud.height) return infinity;
  double miss = -1.0;
  for (int v = 0; v < cloud.height; ++v) {
    for (int u = 0; u < cloud.width; ++u) {
      const Eigen::Vector3d p = cloud.at(u, v).cast<double>();
      if (!p.allFinite()) continue;
      miss = std::max(miss, (camera->project(p) - Eigen::Vector2d(u, v)).norm());
    }
  }
  return miss < 0.0 ? infinity : miss;
}
