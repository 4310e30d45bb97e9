#pragma once

#include "cloud/clusters.h"
#include "frame/cloud.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// A cloud filtered and cut into what hangs together: all of section 5's order that needs to know
/// neither tool nor load.
struct SegmentedCloud {
  Points points;      ///< inside the bounds, downsampled to R, without outliers
  Clusters clusters;  ///< of them
  Points beyond;      ///< measured points behind the bounds; they show what is free
  Points noise;       ///< what the low-pass dropped
};

/// Crop, z-reprojection, downsample to R, low-pass, Euclidean clusters. Pure.
/// Source: docs/method.md section 5.
///
/// Points belong together that are nearer than the cluster tolerance or 2 R, whichever is more:
/// downsampling to R leaves neighbours up to that far apart, and a surface must not fall to pieces.
SegmentedCloud segmentCloud(const Cloud& cloud, const Parameters& parameters);

/// The depth of `filter.zReprojection` where it is set; else `p` as it is.
Eigen::Vector3f reprojected(Eigen::Vector3f p, const FilterParameters& filter);

/// Euclidean clusters with the tolerance that segmentCloud uses.
Clusters clustersOf(const Points& points, const Parameters& parameters);

}  // namespace boomwatch
