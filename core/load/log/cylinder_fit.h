#pragma once

#include <array>
#include <optional>

#include "load/log/axis_search.h"

namespace boomwatch {

/// A log as one frame shows it. Camera frame, metres. Arrays: towards -axis, towards +axis.
struct CylinderFit {
  LoadFault fault = LoadFault::None;  ///< the rest holds only where there is none
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< length 1
  double length = 0.0;                              ///< between the ends, seen or not
  double radius = 0.0;
  /// Whether the log is seen to end at centre -+ axis length / 2, or is only hidden from there on.
  std::array<bool, 2> endSeen{};
  std::array<double, 2> hidden{};  ///< how far it may go on there
  std::array<double, 2> arm{};     ///< how far it reaches out of the tool
  std::array<double, 2> shown{};   ///< how much of that is seen
};

/// A log that was seen a moment ago, where it is by now, about. Camera frame, metres.
struct ExpectedCylinder {
  Eigen::Vector3d from, to;  ///< the ends of its axis
  double radius;
};

/// Metres, but for endOn.
struct CylinderLimits {
  double toolRadius;  ///< along the log, from where it passes the tool: not load, but tool
  double minRadius, maxRadius;
  double endOn = 0.2;  ///< radians between axis and view below which its length is not seen
  std::optional<ExpectedCylinder> expected = {};
};

/// Fits a cylinder to what is seen along `start`, a line on its surface, without the tool: least
/// squares over its outline (which gives the radius and where it lies across the view) and the
/// inverse depths of its near side (which give the distance and the tilt), robust against what
/// covers it; then follows it to where it ends. What is expected counts as a few points do. Pure.
CylinderFit fitCylinder(const DepthPatch& patch, const Eigen::Vector3d& tool, const LoadAxis& start,
                        const CylinderLimits& limits);

}  // namespace boomwatch
