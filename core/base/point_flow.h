#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

namespace boomwatch {

/// Where a point went from one image to the next. Pixels.
struct FollowedPoint {
  std::size_t index = 0;  ///< of the point that was followed
  cv::Point2f position;   ///< in the second image; may lie a little outside it
  double error = 0.0;     ///< distance from the point to where the way back ends
};

/// How followPoints() searches. The defaults are OpenCV's.
struct FlowSearch {
  cv::Size window{21, 21};  ///< what is compared around a point, pixels
  int levels = 3;           ///< halvings of the image, at most
  /// Of the search at each level: steps, and pixels a step.
  cv::TermCriteria end{cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.01};
};

/// Follows points from `before` to `after` (CV_8UC1, of one size) and back, by pyramidal
/// Lucas-Kanade: the forward-backward check of Kalal et al., "Forward-Backward Error: Automatic
/// Detection of Tracking Failures", ICPR 2010. Returns those of `points` that were found both ways,
/// in their order. The search begins at `guess`, one place a point, or at the points themselves
/// when `guess` is empty. Pure; any thread.
std::vector<FollowedPoint> followPoints(const cv::Mat& before, const cv::Mat& after,
                                        const std::vector<cv::Point2f>& points,
                                        const FlowSearch& search,
                                        const std::vector<cv::Point2f>& guess = {});

}  // namespace boomwatch
