#include "cloud/segmented_cloud.h"

#include <algorithm>

#include "cloud/low_pass.h"
#include "cloud/voxel_grid.h"

namespace boomwatch {
namespace {

using Eigen::Vector3f;

/// Sorts the measured points into those inside the bounds and those behind them: on their way along
/// z or, in perspective, along their ray.
void crop(const Cloud& cloud, const Bounds& bounds, ModelProjection projection, Points& inside,
          Points& beyond) {
  const bool perspective = projection == ModelProjection::Perspective;
  inside.reserve(cloud.size());
  for (const Vector3f& p : cloud.points) {
    if (!isMeasured(p)) continue;
    if (bounds.contains(p)) {
      inside.push_back(p);
    } else if (perspective
                   ? p.z() > bounds.zMin
                   : p.z() > bounds.zMax && bounds.contains({p.x(), p.y(), float(bounds.zMin)})) {
      beyond.push_back(p);
    }
  }
}

}  // namespace

Vector3f reprojected(Vector3f p, const FilterParameters& filter) {
  if (filter.zReprojection) p.z() = static_cast<float>(*filter.zReprojection);
  return p;
}

Clusters clustersOf(const Points& points, const Parameters& parameters) {
  const double tolerance =
      std::max(parameters.filter.clusterTolerance, 2.0 * parameters.model.resolution);
  return euclideanClusters(points, static_cast<float>(tolerance));
}

SegmentedCloud segmentCloud(const Cloud& cloud, const Parameters& parameters) {
  const FilterParameters& filter = parameters.filter;
  const Bounds& bounds = parameters.bounds;
  SegmentedCloud segments;
  Points inside;
  crop(cloud, bounds, parameters.model.projection, inside, segments.beyond);
  for (Vector3f& p : inside) p = reprojected(p, filter);
  const Eigen::Vector3d corner(bounds.xMin, bounds.yMin, bounds.zMin);
  segments.points = voxelCentroids(inside, parameters.model.resolution, corner.cast<float>());
  if (filter.lowPass) {
    segments.points = withoutOutliers(segments.points, filter, segments.noise);
  }
  segments.clusters = clustersOf(segments.points, parameters);
  return segments;
}

}  // namespace boomwatch
