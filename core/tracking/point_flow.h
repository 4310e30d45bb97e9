#pragma once

#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

namespace boomwatch {

/// Where a point went from one image to the next.
struct FollowedPoint {
  std::size_t index = 0;  ///< of the point that was followed
  cv::Point2f position;   ///< in the second image, inside it; pixels
  double error = 0.0;     ///< how far from the point the way back ends (forward-backward), pixels
};

/// The part of an image that matters for what is in `box`: its pyramid takes less time than that of
/// all of it.
cv::Rect flowRegion(const cv::Rect2d& box, cv::Size image);

/// Those of `points` that pyramidal Lucas-Kanade can follow from `before` to `after` (CV_8UC1, of
/// one size) and back, in their order; `window` is what surrounds a point. A pure function.
std::vector<FollowedPoint> followPoints(const cv::Mat& before, const cv::Mat& after,
                                        const std::vector<cv::Point2f>& points, cv::Size window);

/// NCC, -1..1, of what surrounds a point in one image and one in another (CV_8UC1).
double patchSimilarity(const cv::Mat& before, cv::Point2f point, const cv::Mat& after,
                       cv::Point2f other);

}  // namespace boomwatch
