#pragma once

#include <opencv2/core.hpp>

namespace boomwatch {

/// Without the veils that a matcher draws between a near thing and what is behind it, a few pixels
/// wide: disparities that change across or down by more than `steepest` pixels a pixel, as those of
/// no surface do that is not seen nearly edge-on. A plane beside the camera at a distance of h has
/// a slope of B / h. Half of `steepest` is enough where it is no wider than a veil, and steeper
/// than a surface seen at 8 degrees would be: the rim of a near thing, which the matcher draws out
/// towards what is behind it.
///
/// `disparity`: CV_32FC1, pixels, NaN where nothing matched. `focalLength`: pixels. Pure.
cv::Mat withoutFlyingPixels(const cv::Mat& disparity, double steepest, double focalLength);

}  // namespace boomwatch
