#pragma once

#include <optional>

#include "frame/cloud.h"

namespace boomwatch {

/// Where a point of the camera frame (metres) falls in the left image (pixels): u = fx x/z + cx.
struct PinholeProjection {
  double fx = 0.0;
  double fy = 0.0;
  double cx = 0.0;
  double cy = 0.0;

  /// For z > 0 only.
  Eigen::Vector2d operator()(const Eigen::Vector3d& p) const {
    return {fx * p.x() / p.z() + cx, fy * p.y() / p.z() + cy};
  }
};

/// The pinhole that maps the measured points of an organised cloud onto their pixels, by least
/// squares over a sample; absent when there are too few or they do not fit to two pixels.
std::optional<PinholeProjection> fitPinhole(const Cloud& cloud);

}  // namespace boomwatch
