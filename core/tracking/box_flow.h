#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "base/point_flow.h"

namespace boomwatch {

/// The part of an image of size `image` in which what is in `box` can be followed: its pyramid
/// takes less time than that of the whole image.
cv::Rect flowRegion(const cv::Rect2d& box, cv::Size image);

/// followPoints() as the trackers of the tool use it, without the points that leave the image.
/// `window`: what is compared around a point, pixels.
std::vector<FollowedPoint> followInside(const cv::Mat& before, const cv::Mat& after,
                                        const std::vector<cv::Point2f>& points, cv::Size window);

}  // namespace boomwatch
