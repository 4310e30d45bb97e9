#include "cloud/low_pass.h"

#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <algorithm>
#include <vector>

namespace boomwatch {
namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

PclCloud::Ptr cloudOf(const Points& points) {
  PclCloud::Ptr cloud(new PclCloud);
  cloud->reserve(points.size());
  for (const Eigen::Vector3f& p : points) cloud->push_back({p.x(), p.y(), p.z()});
  return cloud;
}

std::vector<bool> keptByStatistics(const Points& points, const FilterParameters& parameters) {
  std::vector<bool> kept(points.size(), true);
  // PCL reads as many distances as it asked for, even where the cloud has fewer points.
  const int others = static_cast<int>(std::min<std::size_t>(points.size() - 1, 1'000'000));
  if (others == 0) return kept;
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter(true);
  filter.setInputCloud(cloudOf(points));
  filter.setMeanK(std::min(parameters.lowPassNeighbours, others));
  filter.setStddevMulThresh(parameters.lowPassDeviations);
  pcl::Indices passed;
  filter.filter(passed);
  for (const auto index : *filter.getRemovedIndices())
    kept[static_cast<std::size_t>(index)] = false;
  return kept;
}

/// As PCL's RadiusOutlierRemoval, which sorts the nearest thousand of each point where a thousand
/// neighbours are asked for; to count them up to that number suffices.
std::vector<bool> keptByRadius(const Points& points, const FilterParameters& parameters) {
  pcl::search::KdTree<pcl::PointXYZ> tree(false);
  tree.setInputCloud(cloudOf(points));
  const auto needed = static_cast<unsigned>(parameters.lowPassMinimum) + 1;  // and the point itself
  std::vector<bool> kept(points.size());
  pcl::Indices found;
  std::vector<float> squaredDistances;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int count = tree.radiusSearch(static_cast<int>(i), parameters.lowPassRadius, found,
                                        squaredDistances, needed);
    kept[i] = count >= static_cast<int>(needed);
  }
  return kept;
}

}  // namespace

Points withoutOutliers(const Points& points, const FilterParameters& parameters, Points& outliers) {
  if (points.empty()) return points;
  const std::vector<bool> kept = parameters.lowPassMethod == LowPassMethod::Radius
                                     ? keptByRadius(points, parameters)
                                     : keptByStatistics(points, parameters);
  Points result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    (kept[i] ? result : outliers).push_back(points[i]);
  }
  return result;
}

}  // namespace boomwatch
