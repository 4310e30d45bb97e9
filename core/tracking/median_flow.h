#pragma once

#include <opencv2/core.hpp>
#include <optional>

namespace boomwatch {

/// Where a box went from one image to the next.
struct MedianFlow {
  cv::Rect2d box;           ///< in the second image, pixels; may reach outside it
  double residual = 0.0;    ///< median distance of a point's motion from the median motion, pixels
  double similarity = 0.0;  ///< median NCC of what surrounds the points, before and after: -1..1
};

/// Follows a grid of points in `box` from `before` to `after` (CV_8UC1, of one size) by pyramidal
/// Lucas-Kanade, keeps the half with the smaller forward-backward error and, of that, the half that
/// looks the more alike, and takes the medians of their motion and of the ratios of their pairwise
/// distances: Kalal et al., "Forward-Backward Error: Automatic Detection of Tracking Failures",
/// ICPR 2010. Absent when too few points can be followed to say. A pure function; any thread.
std::optional<MedianFlow> medianFlow(const cv::Mat& before, const cv::Mat& after,
                                     const cv::Rect2d& box);

}  // namespace boomwatch
