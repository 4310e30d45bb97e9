#pragma once

#include <opencv2/core.hpp>
#include <optional>

namespace boomwatch {

/// Tells whether the picture moves as a whole, which breaks the model's assumption of a static
/// camera. Follows corners from one left image to the next (pyramidal Lucas-Kanade, checked forward
/// and backward) and returns the share of them that moved. A person or a load that moves before a
/// still background moves only few of them.
class SceneMotion {
 public:
  /// `image`: CV_8UC1 or CV_8UC3, any size. Absent for the first image, after a change of size, and
  /// where too few corners could be followed to tell (dark, blank, blurred).
  std::optional<double> shareMoved(const cv::Mat& image);
  /// Forgets the picture before.
  void reset();

 private:
  cv::Mat m_previous;  ///< grey, scaled down
};

}  // namespace boomwatch
