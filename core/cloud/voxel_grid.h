#pragma once

#include <span>

#include "frame/cloud.h"

namespace boomwatch {

/// The mean of the points of every cube with side `leaf` metres, as pcl::VoxelGrid gives it, in
/// order of first appearance. The cubes start at `origin`, so that they can lie in the same columns
/// as the cells of a model: a mean then falls into the cell its points fell into.
///
/// Points must be finite. Takes memory by the number of points, whatever space they span. Pure.
Points voxelCentroids(std::span<const Eigen::Vector3f> points, double leaf,
                      const Eigen::Vector3f& origin);

}  // namespace boomwatch
