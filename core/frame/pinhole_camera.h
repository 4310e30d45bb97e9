#pragma once

#include <Eigen/Core>

namespace boomwatch {

/// A camera without distortion at the origin of the camera frame (x right, y down, z forward,
/// metres). Pixels; the middle of the upper left pixel is (0, 0).
struct PinholeCamera {
  int width = 0, height = 0;  ///< of its picture
  double fx = 0.0, fy = 0.0;  ///< focal lengths
  double cx = 0.0, cy = 0.0;  ///< principal point

  /// With square pixels, and the principal point in the middle of the picture.
  static constexpr PinholeCamera centred(int width, int height, double focalLength) {
    return {width, height, focalLength, focalLength, (width - 1) / 2.0, (height - 1) / 2.0};
  }

  /// The pixel that shows a point, z > 0 only: u = fx x / z + cx.
  Eigen::Vector2d project(const Eigen::Vector3d& p) const {
    return {fx * p.x() / p.z() + cx, fy * p.y() / p.z() + cy};
  }

  /// The direction in which a pixel looks, with z = 1: at depth z it shows z * ray(u, v).
  Eigen::Vector3d ray(double u, double v) const { return {(u - cx) / fx, (v - cy) / fy, 1.0}; }

  /// Whether a pixel lies in the picture: 0 <= u < width, and v likewise. False for NaN.
  bool contains(const Eigen::Vector2d& pixel) const {
    return pixel.x() >= 0.0 && pixel.x() < width && pixel.y() >= 0.0 && pixel.y() < height;
  }

  bool operator==(const PinholeCamera&) const = default;
};

}  // namespace boomwatch
