#pragma once

#include <optional>
#include <vector>

#include "frame/cloud.h"
#include "frame/oriented_box.h"
#include "frame/viewed_box.h"

namespace boomwatch {

/// The crane as far as it is seen: boxes around tool and boom, for watching what they come near to.
/// Camera frame, metres.
struct CraneBoxes {
  std::optional<OrientedBox> tool;  ///< absent where no point is near the tool point
  std::vector<OrientedBox> boom;    ///< its straight segments, the one nearest to the tool first
};

/// Boxes around the straight segments of a boom; see craneBoxes. Pure.
std::vector<OrientedBox> boomSegments(const Points& boom);

/// `cluster`: the points of boom, tool and load that hang together. Those of the load's volume are
/// left out; those within half of `toolSize` of `tool` are the tool; the rest is the boom. It is
/// cut where it bends away from a straight line by more than 40 cm (as lines are simplified by
/// Ramer 1972 and Douglas and Peucker 1973), and each segment gets a box along its principal axes.
/// Components of fewer than 10 points are left out. Only surfaces that face the camera are in it.
/// Pure.
CraneBoxes craneBoxes(const Points& cluster, const Eigen::Vector3f& tool, double toolSize,
                      const std::optional<ViewedBox>& loadVolume);

}  // namespace boomwatch
