#pragma once

#include <array>

#include "load/axis_search.h"

namespace boomwatch {

/// A log as one frame shows it. Camera frame, metres.
struct CylinderFit {
  LoadFault fault = LoadFault::None;  ///< the rest holds only where there is none
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< length 1
  double length = 0.0;                              ///< between the ends, seen or not
  double radius = 0.0;
  /// Whether the log is seen to end at centre -+ axis length / 2, or is only hidden from there on.
  std::array<bool, 2> endSeen{};
};

/// Metres.
struct CylinderLimits {
  double toolRadius;  ///< about the tool point: not load, but tool
  double leastArm;    ///< by which a log reaches out of that on both sides
  double maxRadius;
};

/// Fits a cylinder to what is seen along `start`, without the tool: least squares over its outline
/// (which gives the radius and where it lies across the view) and the inverse depths of its near
/// side (which give the distance and the tilt), robust against what covers it; then follows it to
/// where it ends. Pure.
CylinderFit fitCylinder(const DepthPatch& patch, const LoadBody& body, const LoadAxis& start,
                        const CylinderLimits& limits);

}  // namespace boomwatch
