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

/// Whether the tool was masked. It is masked only when a cluster can be the tool.
enum class ToolMask {
  NoToolPoint,   ///< the position of the tool is unknown
  NothingThere,  ///< no cluster has a point within cluster tolerance + R of the tool point
  /// The cluster's box holds more than half of all points, or of the bounds in both x and y: the
  /// tool touches the ground. Masking this cluster would remove the environment, so none is masked.
  TooLarge,
  Taken,  ///< the tool is masked, and its box is known
};
/// Stable name for files and logs.
std::string_view nameOf(ToolMask mask);

/// The part of the crane that a cluster belongs to.
enum class CranePart {
  None,
  Tool,        ///< the cluster at the tool point: tool, load and the boom connected to them
  Boom,        ///< a part of the boom that is not connected to the tool; see BoomBeyond
  Remembered,  ///< lies where the crane was a moment ago; see CraneMemory
  MaybeLoad,   ///< so near to the tool that it may be an undetected load
};

/// The clusters that belong to the crane.
struct CraneMask {
  ToolMask state = ToolMask::NoToolPoint;
  std::optional<AxisAlignedBox> toolBox;  ///< AABB of the tool's cluster, if and only if Taken
  std::vector<CranePart> parts;           ///< one a cluster
};

/// `points`: the kept points of `cloud`. `clusters`: their partition. `tool`: the tool point, with
/// the same reprojection as `points`. Camera frame, metres.
///
/// The tool's cluster has a point at the tool point. Of several, it is the one whose mean is
/// nearest to `tool`. Clusters without such a point are ignored, because the mean of a long boom
/// may be farther away than that of a stone. Three more kinds of cluster belong to the crane:
/// - clusters wholly within load_tool_size / 2 of the tool point, or within 1.3 load_tool_size of
/// it
///   and close to the load;
/// - clusters that lie mostly where `memory` has the crane;
/// - clusters that BoomBeyond finds.
/// Clusters below cluster_minimum are ignored. Pure.
///
/// `unseenLoad`: the tool may hold an undetected load, such as one that points at the camera. A
/// cluster wholly within load_max_size / 2 of the tool is then MaybeLoad.
CraneMask craneMask(const Points& points, const Clusters& clusters, const Cloud& cloud,
                    const Eigen::Vector3f& tool, const std::optional<ViewedBox>& load,
                    const Parameters& parameters, const CraneMemory& memory, bool unseenLoad);

}  // namespace boomwatch
