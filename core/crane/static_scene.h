#pragma once

#include <optional>

#include "cloud/segmented_cloud.h"
#include "crane/crane_mask.h"
#include "frame/cloud.h"
#include "frame/oriented_box.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// The cloud split into what may enter the model and what was taken out as boom, tool and load.
struct StaticScene {
  Points statics;  ///< inside the bounds, downsampled, without noise and dynamic volume
  /// Measured points beyond zMax inside the bounds in x and y: they show what is free. In
  /// perspective all measured points behind zMin that are outside the bounds.
  Points beyond;
  Points removed;  ///< taken out as dynamic; shown, so that an obstacle among them can be seen
  std::optional<AxisAlignedBox> toolBox;  ///< AABB of the tool's cluster, if and only if Taken
  ToolMask toolMask = ToolMask::NoToolPoint;
  Points toolCluster;  ///< downsampled; of `removed` those that are the tool's now, not the load's
  Points boomCut;      ///< of `removed`: parts of the boom beyond an elbow out of the picture
  std::size_t maybeLoad = 0;  ///< of `removed`: how many may as well be surroundings
  /// Points dropped by the low-pass, or with clusters that are too small: not believed, but no
  /// evidence that nothing is there.
  Points noise;
};

/// What comes after it: small clusters go, the dynamic volume (the AABB of the tool's cluster, and
/// the load's box) goes. `segments` are those of `cloud` with the same parameters. Pure.
///
/// Which clusters are the crane: see craneMask. Where its cluster is too large, it is looked for
/// once more among the points that are not the load's. Without a load nothing is taken for it,
/// unless there may be an `unseenLoad`. With z-reprojection the tool point moves as the points do;
/// the load's box stays where it is.
StaticScene separateStatic(SegmentedCloud segments, const Cloud& cloud,
                           const std::optional<Eigen::Vector3f>& tool,
                           const std::optional<ViewedBox>& load, const Parameters& parameters,
                           const CraneMemory& memory = {}, bool unseenLoad = false);

/// Both.
inline StaticScene separateStatic(const Cloud& cloud, const std::optional<Eigen::Vector3f>& tool,
                                  const std::optional<ViewedBox>& load,
                                  const Parameters& parameters, const CraneMemory& memory = {},
                                  bool unseenLoad = false) {
  return separateStatic(segmentCloud(cloud, parameters), cloud, tool, load, parameters, memory,
                        unseenLoad);
}

}  // namespace boomwatch
