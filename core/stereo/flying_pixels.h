#pragma once

#include <opencv2/core.hpp>

namespace boomwatch {

/// Removes flying pixels: depths that a stereo matcher interpolates across the edge of a near
/// object.
///
/// A pixel is removed when its disparity changes across or down by more than `maxSlope` pixels per
/// pixel. Only a surface seen nearly edge-on has such a slope: a plane at distance h beside the
/// camera has a slope of B / h. In a run of at most 12 pixels half of `maxSlope` is enough, if it
/// is steeper than a surface seen at 8 degrees. Such runs are the smeared rims of near objects.
///
/// `disparity`: CV_32FC1, pixels, NaN without a match. `focalLength`: pixels. Pure.
cv::Mat withoutFlyingPixels(const cv::Mat& disparity, double maxSlope, double focalLength);

}  // namespace boomwatch
