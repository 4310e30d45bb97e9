#pragma once

#include <optional>

#include "cloud/segmented_cloud.h"
#include "crane/crane_mask.h"
#include "frame/cloud.h"
#include "frame/oriented_box.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// The cloud, split into static points for the model and points masked as boom, tool and load.
struct StaticScene {
  Points statics;  ///< inside the bounds, downsampled, without noise and masked points
  /// Measured points beyond zMax, inside the bounds in x and y; the space before them is free. In
  /// perspective: all measured points behind zMin and outside the bounds.
  Points beyond;
  Points removed;  ///< masked; drawn, so that the operator sees an obstacle among them
  std::optional<AxisAlignedBox> toolBox;  ///< AABB of the tool's cluster, if and only if Taken
  ToolMask toolMask = ToolMask::NoToolPoint;
  Points toolCluster;  ///< downsampled; of `removed`, the tool's cluster without the load
  Points boomCut;      ///< of `removed`: parts of the boom beyond an elbow outside the picture
  std::size_t maybeLoad =
      0;  ///< of `removed`: the points that may be an undetected load or an obstacle
  /// Points removed by the low-pass, and points of clusters that are too small. They do not enter
  /// the model, but they do not show free space either.
  Points noise;
};

/// Removes small clusters, and masks the crane: its clusters (see craneMask), the AABB of the
/// tool's cluster and the load's box. `segments`: those of `cloud` with the same parameters. Pure.
///
/// If the tool's cluster is too large, the search runs again without the points of the load.
/// Without a load no point is masked as load, unless there may be an `unseenLoad`. With
/// z-reprojection the tool point moves as the points do; the load's box does not move.
StaticScene separateStatic(SegmentedCloud segments, const Cloud& cloud,
                           const std::optional<Eigen::Vector3f>& tool,
                           const std::optional<ViewedBox>& load, const Parameters& parameters,
                           const CraneMemory& memory = {}, bool unseenLoad = false);

/// The same from an unsegmented cloud.
inline StaticScene separateStatic(const Cloud& cloud, const std::optional<Eigen::Vector3f>& tool,
                                  const std::optional<ViewedBox>& load,
                                  const Parameters& parameters, const CraneMemory& memory = {},
                                  bool unseenLoad = false) {
  return separateStatic(segmentCloud(cloud, parameters), cloud, tool, load, parameters, memory,
                        unseenLoad);
}

}  // namespace boomwatch
