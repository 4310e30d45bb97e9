#pragma once

#include <vector>

#include "load/load_body.h"

namespace boomwatch {

/// A line in space. Camera frame, metres.
struct LoadAxis {
  Eigen::Vector3d point;      ///< the one nearest to the tool
  Eigen::Vector3d direction;  ///< length 1
};

/// Lines past the tool along which the body reaches out of the tool on *both* sides, as a held log
/// does; a boom ends at the tool and so reaches out on one side only. The tool is all that is
/// within `toolRadius` metres of the tool point. The most likely first, at most a few, no two
/// alike; none when nothing reaches out on both sides by more than `leastArm` metres.
/// Deterministic; pure.
std::vector<LoadAxis> findAxes(const DepthPatch& patch, const LoadBody& body, double toolRadius,
                               double leastArm);

}  // namespace boomwatch
