// The whole filter stage against PCL's own filters for its two main steps.
#include <pcl/filters/voxel_grid.h>

#include <algorithm>
#include <iterator>
#include <random>

#include "benchmark.h"
#include "cloud/voxel_grid.h"
#include "crane/static_scene.h"
#include "floor_with_boxes.h"
#include "pcl_peers.h"

using boomwatch::Cloud;
using boomwatch::Parameters;
namespace bench = boomwatch::bench;

namespace {

/// Every tenth pixel unmeasured.
Cloud organisedCloud() {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> tenth(0, 9);
  Cloud cloud = bench::floorWithBoxes();
  for (Eigen::Vector3f& point : cloud.points) {
    if (tenth(random) == 0) point = boomwatch::unmeasuredPoint();
  }
  return cloud;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr downsampledByPcl(
    const pcl::PointCloud<pcl::PointXYZ>::Ptr& cloud, float leaf) {
  pcl::VoxelGrid<pcl::PointXYZ> filter;
  filter.setInputCloud(cloud);
  filter.setLeafSize(leaf, leaf, leaf);
  pcl::PointCloud<pcl::PointXYZ>::Ptr result(new pcl::PointCloud<pcl::PointXYZ>);
  filter.filter(*result);
  return result;
}

}  // namespace

int main() {
  const Parameters parameters;
  const Cloud cloud = organisedCloud();
  boomwatch::Points measured;
  std::copy_if(cloud.points.begin(), cloud.points.end(), std::back_inserter(measured),
               boomwatch::isMeasured);
  const auto forPcl = bench::toPcl(measured);
  const double stage = bench::medianMilliseconds(
      21, [&] { boomwatch::separateStatic(cloud, Eigen::Vector3f(0, 0, 5), {}, parameters); });
  const double voxels = bench::medianMilliseconds(21, [&] {
    boomwatch::voxelCentroids(measured, parameters.model.resolution, Eigen::Vector3f::Zero());
  });
  const auto leaf = static_cast<float>(parameters.model.resolution);
  const double voxelsOfPcl = bench::medianMilliseconds(11, [&] { downsampledByPcl(forPcl, leaf); });
  const auto downsampled = downsampledByPcl(forPcl, leaf);
  const double clustersOfPcl = bench::medianMilliseconds(
      3, [&] { bench::clustersOfPcl(downsampled, parameters.filter.clusterTolerance); });
  bench::print("filter_stage", stage, "ms", "-");
  bench::print("filter_stage_pcl", voxelsOfPcl + clustersOfPcl, "ms", "-");
  bench::print("filter_stage_pcl_over_ours", (voxelsOfPcl + clustersOfPcl) / stage, "x", "-");
  bench::print("voxel_centroids", voxels, "ms", "-");
  bench::print("voxel_centroids_pcl_over_ours", voxelsOfPcl / voxels, "x", "-");
  return 0;
}
