#pragma once

#include <array>
#include <opencv2/core.hpp>
#include <optional>

namespace boomwatch {

/// Which parts of the box move with the target: a box holds some of what is behind it, and that is
/// followed best of all, for it stands still. After the Markov predictor of Vojir and Matas,
/// "Robustifying the Flock of Trackers", CVWW 2011.
class FlowCells {
 public:
  static constexpr int side = 10;
  static constexpr std::size_t count = std::size_t{side} * side;

  FlowCells() { m_together.fill(1.0F); }

  /// Row by row of the box: whether a cell is to be asked where the target goes.
  std::array<bool, count> reliable() const;
  /// Of a cell that could be followed.
  void note(std::size_t cell, bool together);

 private:
  std::array<float, count> m_together;  ///< how often of late it moved with the target, 0..1
};

/// Where a box went from one image to the next.
struct MedianFlow {
  cv::Rect2d box;           ///< in the second image, pixels; may reach outside it
  double residual = 0.0;    ///< median distance of a point's motion from the median motion, pixels
  double similarity = 0.0;  ///< median NCC of what surrounds the points, before and after: -1..1
};

/// Follows a grid of points in `box` from `before` to `after` (CV_8UC1, of one size) by pyramidal
/// Lucas-Kanade, keeps the half with the smaller forward-backward error and, of that, the half that
/// looks the more alike, and takes the medians of their motion and of the ratios of their pairwise
/// distances: Kalal et al., "Forward-Backward Error: Automatic Detection of Tracking Failures",
/// ICPR 2010. Absent when too few points can be followed to say. Any thread.
///
/// With `cells`, only the reliable ones are asked, and all are noted down, if the box moved so far
/// that what stands still can be told from it.
std::optional<MedianFlow> medianFlow(const cv::Mat& before, const cv::Mat& after,
                                     const cv::Rect2d& box, FlowCells* cells = nullptr);

}  // namespace boomwatch
