#pragma once

#include "frame/cloud.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// The points without outliers, which are added to `outliers`: what pcl::StatisticalOutlierRemoval
/// or pcl::RadiusOutlierRemoval keep with the five low-pass settings of `parameters`. Points must
/// be finite. Where there are too few points to have the neighbours asked for, the statistical
/// method looks at as many as there are. Pure.
Points withoutOutliers(const Points& points, const FilterParameters& parameters, Points& outliers);

}  // namespace boomwatch
