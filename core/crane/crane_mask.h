#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "cloud/clusters.h"
#include "crane/crane_memory.h"
#include "frame/cloud.h"
#include "frame/viewed_box.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// What became of the tool: it is masked only where a cluster was found that can be the tool.
enum class ToolMask {
  NoToolPoint,   ///< nobody said where the tool is
  NothingThere,  ///< no cluster has a point within cluster tolerance + R of the tool point
  /// Its box would hold more than half of all points, or more than half of the bounds in both x and
  /// y: the tool touches the ground or the like. Masking it would hide the scene, so nothing is.
  TooLarge,
  Taken,  ///< a box around the tool is known
};
/// Stable name for files and logs.
std::string_view nameOf(ToolMask mask);

/// Which part of the crane a cluster is.
enum class CranePart {
  None,
  Tool,        ///< what is found at the tool: tool, boom and load as far as they hang together
  Boom,        ///< a part of the boom that does not hang together with the tool; see BoomBeyond
  Remembered,  ///< was one of the others a moment ago
  MaybeLoad,   ///< is so near to the tool that it can be a load that was not found
};

/// Which clusters are the crane.
struct CraneMask {
  ToolMask state = ToolMask::NoToolPoint;
  std::optional<AxisAlignedBox> toolBox;  ///< AABB of the tool's cluster, if and only if Taken
  std::vector<CranePart> parts;           ///< one a cluster
};

/// `points` are those of `cloud` that were kept, `clusters` their partition, `tool` the tool's
/// point as they have it, all in the camera frame.
///
/// The tool's cluster is the one whose centre (mean of its points) is nearest to `tool`, among
/// those that have a point at the tool: a long boom's centre is far from its end, and a stone's may
/// be nearer. Clusters go with it that lie wholly within half of load_tool_size of the tool point,
/// or within somewhat more than all of it and close to the load, and those that lie mostly where
/// `memory` has the crane. Clusters below cluster_minimum are no part of anything. Pure.
///
/// `unseenLoad`: there may be a load that was not found, as one that points at the camera is not.
/// Whatever lies wholly within half of load_max_size of the tool may then be a part of it.
CraneMask craneMask(const Points& points, const Clusters& clusters, const Cloud& cloud,
                    const Eigen::Vector3f& tool, const std::optional<ViewedBox>& load,
                    const Parameters& parameters, const CraneMemory& memory, bool unseenLoad);

}  // namespace boomwatch
