#pragma once

#include "frame/cloud.h"

namespace boomwatch {

/// What the camera sees along its own rays. A model of columns along z cannot tell whether a
/// surface is hidden by something that stands in the same column but beside it in the picture; this
/// can. Keeps a reference to the cloud. Const; any thread.
class DepthView {
 public:
  /// Sees nothing where the cloud has no camera.
  explicit DepthView(const Cloud& cloud) : m_cloud(cloud) {}

  /// Whether the rays to a piece of surface `size` metres wide around `surface` (camera frame) all
  /// go on to something more than `room` metres farther away: it is not there. False where a ray
  /// leaves the picture or measured nothing.
  bool looksThrough(const Eigen::Vector3d& surface, double size, double room) const;

  /// Whether the ray to `surface` (camera frame) ends more than `room` metres before it: whatever
  /// is there, this frame does not show it. False where the ray is outside the picture or measured
  /// nothing.
  bool hides(const Eigen::Vector3d& surface, double room) const;

 private:
  /// What the camera measured along the ray to a point before it; null outside the picture.
  const Eigen::Vector3f* seenTowards(const Eigen::Vector3d& point) const;

  const Cloud& m_cloud;
};

}  // namespace boomwatch
