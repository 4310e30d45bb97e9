#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frame/cloud.h"

namespace boomwatch {

/// Euclidean clusters: two points belong together if a chain of points leads from one to the other
/// with every step shorter than `tolerance` metres.
///
/// The same partition as pcl::EuclideanClusterExtraction on the same points. Returns a label a
/// point, 0..n-1 in order of first appearance; points that are not finite get `noCluster`.
struct Clusters {
  static constexpr std::int32_t noCluster = -1;
  std::vector<std::int32_t> labels;  ///< one a point
  std::vector<std::int32_t> sizes;   ///< points a cluster
};

Clusters euclideanClusters(std::span<const Eigen::Vector3f> points, float tolerance);

}  // namespace boomwatch
