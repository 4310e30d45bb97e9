#pragma once

#include <opencv2/core.hpp>

namespace boomwatch {

/// Takes the noise out of the disparities of a still camera. A matcher's noise of half a pixel is
/// decimetres at a few metres, and because a clearance is a minimum over many cells it sees only
/// the noise that points towards the camera.
///
/// In time: the running mean of a pixel's disparities. A disparity that lies `jump` pixels from it
/// may be noise, and counts once `settled` frames in a row agree. It counts at once when it is
/// nearer by more than noise ever is: what comes near must not wait. Where nothing was matched for
/// as long as is averaged it counts at once as well, unless a surface that has been still for so
/// long lies within `jump` of it `nearby`: a patch that gains structure, as at the edge of a
/// shadow, is matched badly at first.
/// In space: the mean of the neighbours whose disparity is within `alike` pixels of the centre's,
/// so that edges stay; done twice. A pixel that is like hardly any of them, though within `jump` of
/// many, is noise of their surface and loses its disparity.
/// Used by one thread.
class DisparitySmoother {
 public:
  static constexpr float jump = 3.0F;
  static constexpr float clearlyNearer = 8.0F;
  static constexpr int settled = 5;
  static constexpr int nearby = 30;  ///< pixels, across and down
  static constexpr float alike = 1.0F;

  /// `disparity`: CV_32FC1, pixels, NaN where nothing matched. `frames`: the newest weighs
  /// 1/frames (earlier, while there are fewer: as much as each of those before); 1: nothing is
  /// done. Forgets when the size changes.
  cv::Mat overTime(const cv::Mat& disparity, int frames);
  void reset();

  /// `window`: pixels, full width; below 2: nothing is done. Pure.
  static cv::Mat overSpace(const cv::Mat& disparity, int window);

 private:
  cv::Mat m_mean;    ///< CV_32FC1
  cv::Mat m_frames;  ///< CV_32FC1: frames m_mean stands for; below 0, frames without a match
};

}  // namespace boomwatch
