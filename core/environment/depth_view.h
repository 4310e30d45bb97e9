#pragma once

#include "frame/cloud.h"

namespace boomwatch {

/// The depths that the camera measured along its own rays. The cells of a parallel model are
/// columns along z, not rays: only the rays tell whether an object occludes a surface. Keeps a
/// reference to the cloud. Const; any thread.
class DepthView {
 public:
  /// All answers are false when the cloud has no camera.
  explicit DepthView(const Cloud& cloud) : m_cloud(cloud) {}

  /// Whether the camera sees through a patch of `size` metres around `surface` (camera frame): all
  /// rays to the patch end more than `room` metres behind it. False when a ray is outside the
  /// picture or has no depth.
  bool looksThrough(const Eigen::Vector3d& surface, double size, double room) const;

  /// Whether `surface` (camera frame) is occluded: the ray to it ends more than `room` metres
  /// before it. False when the ray is outside the picture or has no depth.
  bool hides(const Eigen::Vector3d& surface, double room) const;

 private:
  /// The point that the camera measured along the ray to `point`. Null outside the picture, and for
  /// a point that is not in front of the camera.
  const Eigen::Vector3f* seenTowards(const Eigen::Vector3d& point) const;

  const Cloud& m_cloud;
};

}  // namespace boomwatch
