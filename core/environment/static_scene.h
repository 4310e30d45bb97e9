#pragma once

#include <optional>

#include "frame/cloud.h"
#include "frame/oriented_box.h"
#include "pipeline/parameters.h"

namespace boomwatch {

/// The cloud split into what may enter the model and what was taken out as boom, tool and load.
struct StaticScene {
  Points statics;  ///< inside the bounds, downsampled, without noise and dynamic volume
  /// Measured points beyond zMax inside the bounds in x and y: they show what is free.
  Points beyond;
  Points removed;  ///< taken out as dynamic; shown, so that an obstacle among them can be seen
  std::optional<AxisAlignedBox> toolBox;  ///< AABB of the cluster nearest to the tool point
  std::size_t noise = 0;                  ///< points dropped with clusters that are too small
};

/// Filtering and segmentation in the order of method.md section 5: crop, z-reprojection,
/// downsample to R, low-pass, Euclidean clusters, small clusters go, the dynamic volume (the AABB
/// of the cluster whose centre is nearest to `tool`, and the load's box) goes. Pure.
/// Without a tool point no cluster is taken for the tool; without a load nothing is taken for it.
StaticScene separateStatic(const Cloud& cloud, const std::optional<Eigen::Vector3f>& tool,
                           const std::optional<OrientedBox>& load, const Parameters& parameters);

}  // namespace boomwatch
