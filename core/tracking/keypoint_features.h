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

/// Finds FAST corners in three sizes, spread over the whole image, and describes them by BRISK,
/// which turns with the corner. Keeps memory of nothing; used by one thread.
class KeypointExtractor {
 public:
  KeypointExtractor();

  /// The number of corners is bounded: all over `image` (CV_8UC1), and more of them in `dense`.
  KeypointFeatures extract(const cv::Mat& image, const cv::Rect2d& dense) const;

 private:
  cv::Ptr<cv::Feature2D> m_descriptor;
};

}  // namespace boomwatch
