#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace boomwatch {

/// Corners of an image, and what each looks like.
struct KeypointFeatures {
  std::vector<cv::Point2d> positions;  ///< pixels
  cv::Mat descriptors;                 ///< CV_8UC1, one row a corner; compared by Hamming distance
};

/// Where corners are looked for: all over the image, and more of them in its dense part, or in that
/// alone, which takes less time.
enum class KeypointReach { Everywhere, DensePart };

/// FAST corners of `image` (CV_8UC1) in three sizes, spread over it, described by BRISK, which
/// turns with the corner. Their number is bounded. Of any thread.
KeypointFeatures keypointsOf(const cv::Mat& image, const cv::Rect2d& dense, KeypointReach reach);

}  // namespace boomwatch
