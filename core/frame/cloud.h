#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "frame/depth_noise.h"
#include "frame/pinhole_camera.h"

namespace boomwatch {

/// 3-D points in the camera frame, metres.
using Points = std::vector<Eigen::Vector3f>;

/// 3-D points in the camera frame, metres. A point that was not measured is NaN in all three.
///
/// Organised: row-major, `width` x `height`, point (column, row) belongs to the pixel (column, row)
/// of the rectified left image. Unorganised: height is 1.
struct Cloud {
  int width = 0;
  int height = 0;
  Points points;
  /// What measured an organised cloud, of its size: point (column, row) lies on the camera's
  /// ray(column, row). The source sets it. Absent where the points lie on no camera's rays.
  std::optional<PinholeCamera> camera;
  DepthNoise noise;  ///< of the points; the source sets it

  bool organised() const { return height > 1; }
  std::size_t size() const { return points.size(); }
  /// Organised clouds; column and row must lie inside.
  const Eigen::Vector3f& at(int column, int row) const {
    return points[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(column)];
  }
};

/// What stands where nothing was measured: NaN in all three.
inline Eigen::Vector3f unmeasuredPoint() {
  return Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN());
}

/// Whether all three coordinates are finite.
inline bool isMeasured(const Eigen::Vector3f& p) {
  return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
}

}  // namespace boomwatch
