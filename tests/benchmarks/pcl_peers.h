#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>

#include "frame/cloud.h"

namespace boomwatch::bench {

inline pcl::PointCloud<pcl::PointXYZ>::Ptr toPcl(const Points& points) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const auto& p : points) cloud->push_back({p.x(), p.y(), p.z()});
  return cloud;
}

/// How many clusters PCL finds, of any size; `tolerance` in metres.
inline std::size_t clustersOfPcl(const pcl::PointCloud<pcl::PointXYZ>::Ptr& cloud,
                                 double tolerance) {
  const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>(false));
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setSearchMethod(tree);
  extraction.setClusterTolerance(tolerance);
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> found;
  extraction.extract(found);
  return found.size();
}

}  // namespace boomwatch::bench
