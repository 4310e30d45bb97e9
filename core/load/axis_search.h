#pragma once

#include <vector>

#include "load/load_body.h"

namespace boomwatch {

/// A line in space. Camera frame, metres.
struct LoadAxis {
  Eigen::Vector3d point;      ///< the one nearest to the tool
  Eigen::Vector3d direction;  ///< length 1
};

/// What a line along a load can be. Metres.
struct AxisLimits {
  double toolRadius;  ///< along the line, from where it passes the tool: not load, but tool
  double leastArm;    ///< by which a load reaches out of that on both sides
  double farthest;    ///< from the tool point to the line: a grapple is held above its load
};

/// Lines past the tool along which the body reaches out of the tool on *both* sides, as a held log
/// does; a boom ends at the tool and so reaches out on one side only. They lie on the surface that
/// is seen. The most likely first, at most a few, no two alike. Deterministic; pure.
///
/// Looks along a fan of lines in the picture: a line in space is one there, and its inverse depth
/// changes along it as a straight line does.
std::vector<LoadAxis> findAxes(const DepthPatch& patch, const LoadBody& body,
                               const AxisLimits& limits);

}  // namespace boomwatch
