#pragma once

#include <array>

#include "load/log/viewed_cylinder.h"

namespace boomwatch {

/// Where a cylinder ends, as seen in its frame.
struct CylinderEnds {
  std::array<double, 2> u{};         ///< where its near line ends: on the -u side, on the +u side
  std::array<bool, 2> seen{};        ///< false: hidden behind something, or out of the picture
  std::array<double, 2> farthest{};  ///< how far a hidden end may be; a seen one is at `u`
  std::array<double, 2> shown{};     ///< how much of it is seen on either side, in u
  double filled = 0.0;               ///< share of what is between and not covered, seen as cylinder
  /// The place on the axis, metres from pointA along direction, for an end at `u`.
  static double alongAxis(const ViewedCylinder& cylinder, double u);
};

/// Follows `cylinder` from where it passes the tool to both sides until the surface that is seen is
/// no longer its own. What stands before it does not end it. `tool` in the frame's axes, metres;
/// what is within `range.toolRadius` of it along the cylinder is passed over.
CylinderEnds findEnds(const DepthPatch& patch, const CylinderFrame& frame,
                      const ViewedCylinder& cylinder, const Eigen::Vector3d& tool,
                      const AlongRange& range);

}  // namespace boomwatch
