#pragma once

#include <optional>
#include <string_view>

#include "environment/crane_memory.h"
#include "frame/cloud.h"
#include "frame/oriented_box.h"
#include "pipeline/parameters.h"

namespace boomwatch {

/// What became of the tool: it is masked only where a cluster was found that can be the tool.
enum class ToolMask {
  NoToolPoint,   ///< nobody said where the tool is
  NothingThere,  ///< no cluster has a point within cluster tolerance + R of the tool point
  /// Its box would hold more than half of all points, or more than half of the bounds in both x and
  /// y: the tool touches the ground or the like. Masking it would hide the scene, so nothing is.
  TooLarge,
  Taken,  ///< `toolBox` is set
};
/// Stable name for files and logs.
std::string_view nameOf(ToolMask mask);

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
  /// Points dropped by the low-pass, or with clusters that are too small: not believed, but no
  /// evidence that nothing is there.
  Points noise;
};

/// Filtering and segmentation in the order of method.md section 5: crop, z-reprojection,
/// downsample to R, low-pass, Euclidean clusters, small clusters go, the dynamic volume (the AABB
/// of the tool's cluster, and the load's box) goes. Pure.
///
/// Points belong together that are nearer than the cluster tolerance or 2 R, whichever is more:
/// downsampling to R leaves neighbours up to that far apart, and a surface must not fall to pieces.
///
/// The tool's cluster is the one whose centre (mean of its points) is nearest to `tool`, among
/// those that have a point at the tool: a long boom's centre is far from its end, and a stone's may
/// be nearer. Clusters go with it that lie wholly within half of
/// load_tool_size of the tool point, or within somewhat more than all of it and close to the load,
/// and those that lie mostly where `memory` has the crane. See ToolMask for when none is taken.
/// Without a load nothing is taken for it. With z-reprojection the tool point moves as the points
/// do; the load's box stays where it is.
StaticScene separateStatic(const Cloud& cloud, const std::optional<Eigen::Vector3f>& tool,
                           const std::optional<OrientedBox>& load, const Parameters& parameters,
                           const CraneMemory& memory = {});

}  // namespace boomwatch
