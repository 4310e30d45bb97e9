#pragma once

#include <vector>

#include "frame/bounds.h"
#include "load/depth_patch.h"
#include "load/load_detection.h"

namespace boomwatch {

/// What hangs together with the tool: load, tool and the part of the boom that is near.
struct LoadBody {
  std::vector<int> cells;               ///< of the patch
  std::vector<Eigen::Vector3d> points;  ///< one a cell; camera frame, metres
  Eigen::Vector3d tool;                 ///< the tool point, without the noise of its pixel
  /// Unit normals of the large surfaces (ground, wall) that were taken away from it.
  std::vector<Eigen::Vector3d> surfaces;
  LoadFault fault = LoadFault::None;  ///< NothingAtTool or OnSurface when there is no body
};

/// What limits the growing. Metres.
struct BodyLimits {
  double reach;       ///< how far from the tool
  double toolRadius;  ///< what the tool may hide is sought up to here, and half as far again
  const Bounds& bounds;
};

/// Grows from the tool's cell to neighbours of about the same depth, and again from what is seen
/// beside the tool: the far side of a log comes out from behind the grapple with a jump in depth.
/// The ground and walls (planes that go on to the limit of reach) are taken away first. Pure.
LoadBody growBody(const DepthPatch& patch, const Eigen::Vector3f& tool, const BodyLimits& limits);

}  // namespace boomwatch
