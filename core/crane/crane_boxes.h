#pragma once

#include <optional>
#include <vector>

#include "frame/cloud.h"
#include "frame/oriented_box.h"
#include "frame/viewed_box.h"

namespace boomwatch {

/// Boxes around the visible surfaces of tool and boom, from which the distance is measured. Camera
/// frame, metres.
struct CraneBoxes {
  std::optional<OrientedBox> tool;  ///< absent when no point lies near the tool point
  std::vector<OrientedBox> boom;    ///< its straight segments, the one nearest to the tool first
};

/// Boxes around the straight segments of a boom; see craneBoxes. Pure.
std::vector<OrientedBox> boomSegments(const Points& boom);

/// `cluster`: the points of boom, tool and load. Points in the load's volume are ignored, points
/// within half of `toolSize` (metres) of `tool` belong to the tool, and the rest to the boom. The
/// boom is cut where it deviates from a straight line by more than 40 cm (line simplification by
/// Ramer 1972, Douglas and Peucker 1973). Each segment gets a box along its principal axes.
/// Segments of fewer than 10 points are ignored. The boxes hold only surfaces that face the camera.
/// Pure.
CraneBoxes craneBoxes(const Points& cluster, const Eigen::Vector3f& tool, double toolSize,
                      const std::optional<ViewedBox>& loadVolume);

}  // namespace boomwatch
