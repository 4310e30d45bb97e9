#pragma once

#include <Eigen/Core>

namespace boomwatch {

/// The part of space that is watched, in the camera frame (x right, y down, z forward), metres.
struct Bounds {
  double xMin = -10.0;
  double xMax = 10.0;
  double yMin = -5.75;
  double yMax = 5.75;
  double zMin = 0.0;
  double zMax = 10.0;

  /// Half open in x and y, as the cells are; zMax belongs to it (it has a depth level). Never a
  /// NaN.
  bool contains(const Eigen::Vector3f& p) const {
    return p.x() >= xMin && p.x() < xMax && p.y() >= yMin && p.y() < yMax && p.z() >= zMin &&
           p.z() <= zMax;
  }
  bool operator==(const Bounds&) const = default;
};

}  // namespace boomwatch
