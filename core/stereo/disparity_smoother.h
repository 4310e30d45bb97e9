#pragma once

#include <opencv2/core.hpp>

namespace boomwatch {

/// Takes the noise out of the disparities of a still camera. A matcher's noise of half a pixel is
/// decimetres at a few metres, and because a clearance is a minimum over many cells it sees only
/// the noise that points towards the camera.
///
/// In time: the mean of a pixel's last frames. A disparity that lies `jump` pixels from that mean
/// is something else: its mean begins anew. A pixel is measured once `settled` frames in a row
/// agree, so what is new is seen that many frames later than without.
/// In space: the mean of the neighbours whose disparity is within `alike` pixels of the centre's,
/// so that edges stay; done twice. Used by one thread.
class DisparitySmoother {
 public:
  static constexpr float jump = 3.0F;
  static constexpr int settled = 5;
  static constexpr float alike = 1.0F;

  /// `disparity`: CV_32FC1, pixels, NaN where nothing matched. `frames` to average, 1: none.
  /// Forgets when the size changes.
  cv::Mat overTime(const cv::Mat& disparity, int frames);
  void reset();

  /// `window`: pixels, full width; below 2: nothing is done. Pure.
  static cv::Mat overSpace(const cv::Mat& disparity, int window);

 private:
  cv::Mat m_mean;    ///< CV_32FC1
  cv::Mat m_frames;  ///< CV_32FC1: how many frames m_mean stands for
};

}  // namespace boomwatch
