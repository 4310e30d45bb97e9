#pragma once

#include "environment/grid_geometry.h"
#include "frame/clearance.h"
#include "frame/oriented_box.h"

namespace boomwatch {

/// Whether a box can be searched around: its numbers finite and below a million kilometres, no size
/// negative, its axes at right angles and of length 1. A size of zero is fine. Pure.
bool isUsable(const OrientedBox& box);

/// Describes the shortest line between a point of the solid box and a cell's surface point: its
/// length, the part of the box that `onLoad` lies on, and what quantisation alone can change:
/// half a cell's extent along the line's direction n, |n.x| R/2 + |n.y| R/2 + |n.z| step/2 (in
/// perspective with a cell's size there); where
/// the points coincide, half the cell's diagonal. Camera frame, metres. Pure.
Nearest nearestPair(const GridGeometry& geometry, const OrientedBox& box,
                    const Eigen::Vector3d& onLoad, const Eigen::Vector3d& onEnvironment);

/// Measured when there is a pair, NothingInRange when there is none.
Clearance clearanceFrom(const std::optional<Nearest>& nearest);

}  // namespace boomwatch
