#include "environment/low_pass.h"

#include <pcl/filters/radius_outlier_removal.h>
#include <pcl/filters/statistical_outlier_removal.h>
#include <pcl/point_types.h>

#include <algorithm>

namespace boomwatch {
namespace {

using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

template <class Filter>
Points keptBy(Filter& filter, const Points& points) {
  const PclCloud::Ptr cloud(new PclCloud);
  cloud->reserve(points.size());
  for (const Eigen::Vector3f& p : points) cloud->push_back({p.x(), p.y(), p.z()});
  filter.setInputCloud(cloud);
  pcl::Indices kept;
  filter.filter(kept);
  Points result;
  result.reserve(kept.size());
  for (const auto index : kept) result.push_back(points[static_cast<std::size_t>(index)]);
  return result;
}

}  // namespace

Points withoutOutliers(const Points& points, const FilterParameters& parameters) {
  if (points.empty()) return points;
  if (parameters.lowPassMethod == LowPassMethod::Radius) {
    pcl::RadiusOutlierRemoval<pcl::PointXYZ> filter;
    filter.setRadiusSearch(parameters.lowPassRadius);
    filter.setMinNeighborsInRadius(parameters.lowPassMinimum);
    return keptBy(filter, points);
  }
  // PCL reads as many distances as it asked for, even where the cloud has fewer points.
  const int others = static_cast<int>(std::min<std::size_t>(points.size() - 1, 1'000'000));
  if (others == 0) return points;
  pcl::StatisticalOutlierRemoval<pcl::PointXYZ> filter;
  filter.setMeanK(std::min(parameters.lowPassNeighbours, others));
  filter.setStddevMulThresh(parameters.lowPassDeviations);
  return keptBy(filter, points);
}

}  // namespace boomwatch
