#pragma once

#include <array>

#include "load/viewed_cylinder.h"

namespace boomwatch {

/// Where a cylinder ends, as seen in its frame.
struct CylinderEnds {
  std::array<double, 2> u{};   ///< where its near line ends: on the -u side, on the +u side
  std::array<bool, 2> seen{};  ///< false: hidden behind something, or out of the picture
  double filled = 0.0;         ///< share of what is between, outside the tool, seen as cylinder
  double through = 0.0;        ///< share of it that is seen to be farther away: not there
  /// The place on the axis, metres from pointA along direction, for an end at `u`.
  static double alongAxis(const ViewedCylinder& cylinder, double u);
};

/// Follows `cylinder` from `uFrom` (at the tool) to both sides until the surface that is seen is no
/// longer its own. What stands before it does not end it. `tool` in the frame's axes, metres.
CylinderEnds findEnds(const DepthPatch& patch, const CylinderFrame& frame,
                      const ViewedCylinder& cylinder, const Eigen::Vector3d& tool,
                      double toolRadius);

}  // namespace boomwatch
