// Euclidean clusters against pcl::EuclideanClusterExtraction on the same points.
#include <pcl/io/pcd_io.h>

#include <filesystem>
#include <string>

#include "benchmark.h"
#include "cloud/clusters.h"
#include "cloud/voxel_grid.h"
#include "floor_with_boxes.h"
#include "pcl_peers.h"

using boomwatch::Points;
namespace bench = boomwatch::bench;

namespace {

void compare(const std::string& name, const Points& points, float tolerance, const char* bar) {
  const auto cloud = bench::toPcl(points);
  std::size_t ours = 0;
  std::size_t theirs = 0;
  const double own = bench::medianMilliseconds(
      15, [&] { ours = boomwatch::euclideanClusters(points, tolerance).sizes.size(); });
  const double peer =
      bench::medianMilliseconds(3, [&] { theirs = bench::clustersOfPcl(cloud, tolerance); });
  bench::print((name + "_points").c_str(), static_cast<double>(points.size()), "points", "-");
  bench::print((name + "_time").c_str(), own, "ms", "-");
  bench::print((name + "_pcl_over_ours").c_str(), peer / own, "x", bar);
  bench::print((name + "_difference").c_str(),
               static_cast<double>(ours) - static_cast<double>(theirs), "clusters", "0");
}

void compareRawAndDownsampled(const std::string& name, const Points& points) {
  const Points downsampled = boomwatch::voxelCentroids(points, 0.04, Eigen::Vector3f::Zero());
  // As the filter stage does by default; then steps as short as the spacing, which tears surfaces
  // into thousands of pieces and leaves PCL little to search; then without downsampling.
  compare("clusters_" + name + "_4cm_by_10cm", downsampled, 0.1F, ">=15");
  compare("clusters_" + name + "_4cm_by_4cm", downsampled, 0.04F, "-");
  compare("clusters_" + name + "_raw_by_4cm", points, 0.04F, ">=15");
}

}  // namespace

/// Arguments: PCD files to measure as well, e.g. recordings with ground truth.
int main(int count, char** arguments) {
  compareRawAndDownsampled("synthetic", bench::floorWithBoxes().points);
  for (int k = 1; k < count; ++k) {
    pcl::PointCloud<pcl::PointXYZ> cloud;
    if (pcl::io::loadPCDFile(arguments[k], cloud) != 0) return 1;
    Points points;
    for (const auto& p : cloud) {
      if (boomwatch::isMeasured(p.getVector3fMap())) points.emplace_back(p.x, p.y, p.z);
    }
    compareRawAndDownsampled(std::filesystem::path(arguments[k]).stem().string(), points);
  }
  return 0;
}
