#pragma once

#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
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

/// Finds FAST corners in three sizes, spread over the image, and describes them by BRISK, which
/// turns with the corner. Keeps memory of nothing; used by one thread.
class KeypointExtractor {
 public:
  KeypointExtractor();

  /// The number of corners in `image` (CV_8UC1) is bounded.
  KeypointFeatures extract(const cv::Mat& image, const cv::Rect2d& dense,
                           KeypointReach reach) const;

 private:
  cv::Ptr<cv::Feature2D> m_descriptor;
};

}  // namespace boomwatch
