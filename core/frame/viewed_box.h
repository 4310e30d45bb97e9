#pragma once

#include "frame/oriented_box.h"

namespace boomwatch {

/// A box as a sensor of depth sees it: where points of it may be measured. Camera frame, metres.
struct ViewedBox {
  OrientedBox box;
  /// 1/m: by how much more, and by how much less, than its own inverse depth that of a point of the
  /// box may be measured (Eq. 5: an error of disparity is one of inverse depth).
  double before = 0.0, behind = 0.0;

  ViewedBox(const OrientedBox& exact, double beforeIt = 0.0, double behindIt = 0.0)
      : box(exact), before(beforeIt), behind(behindIt) {}

  /// Whether what is measured at `p` may lie in the box, along the line of sight. The surface
  /// belongs to it.
  bool contains(const Eigen::Vector3d& p) const;
};

}  // namespace boomwatch
