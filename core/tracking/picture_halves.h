#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace boomwatch {

/// A picture that is wanted at many smaller sizes. It is halved as often as leaves it larger than
/// the size wanted: from there, linear interpolation passes no pixel over, and costs little.
class PictureHalves {
 public:
  /// Shares the pixels of `picture`, which is not empty.
  explicit PictureHalves(const cv::Mat& picture) : m_halves{picture} {}
  cv::Mat resized(cv::Size size);

 private:
  std::vector<cv::Mat> m_halves;  ///< the picture first; grows as needed
};

}  // namespace boomwatch
