#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frame/cloud.h"

namespace boomwatch {

/// A partition of points. Labels are 0..n-1 in order of first appearance.
struct Clusters {
  static constexpr std::int32_t noCluster = -1;
  std::vector<std::int32_t> labels;  ///< one a point
  std::vector<std::int32_t> sizes;   ///< points a cluster
};

/// Two points belong together if a chain of points leads from one to the other with every step
/// shorter than `tolerance` metres: the same partition as pcl::EuclideanClusterExtraction on the
/// same points. Points that are not finite get `noCluster`. Pure.
Clusters euclideanClusters(std::span<const Eigen::Vector3f> points, float tolerance);

}  // namespace boomwatch
