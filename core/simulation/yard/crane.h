#pragma once

#include "simulation/yard/part.h"

namespace boomwatch {

/// Where a crane holds its load. Yard frame (level, y down), metres, radians.
struct CranePose {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();  ///< of the boom, where the grapple hangs
  double yaw = 0.0;                               ///< of the grapple about the vertical
  double swingX = 0.0, swingZ = 0.0;              ///< how far the grapple hangs out of plumb
};

/// The log that it carries, along the grapple's z.
struct CarriedLog {
  double length = 2.4;
  double radius = 0.16;
  double tilt = 0.0;  ///< about the grapple's x

  /// The log's centre below the boom's tip.
  double drop() const { return 0.98 + radius; }
};

/// A forestry crane whose pillar stands beside the camera: main boom, jib with a telescope, link,
/// rotator and grapple.
struct Crane {
  Eigen::Vector3d pillar{1.9, 3.4, 1.7};  ///< its foot, yard frame

  /// All that moves with it but the load; YardKind Crane, and Tool from the link on.
  Parts partsAt(const CranePose& pose, const CarriedLog& log) const;
};

/// The load as a part: a cylinder around its box's y. Yard frame.
Part logAt(const CranePose& pose, const CarriedLog& log);

/// The middle of the rotator: the tool's point. Yard frame.
Eigen::Vector3d toolPointAt(const CranePose& pose);

}  // namespace boomwatch
