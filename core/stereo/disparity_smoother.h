#pragma once

#include <opencv2/core.hpp>

namespace boomwatch {

/// Reduces the noise of disparities. Matching noise of half a pixel is decimetres at a few metres.
/// A clearance is a minimum over many cells, so it keeps the noise that points towards the camera.
///
/// Over time, for a static camera: the running mean of each pixel. A disparity more than `jump`
/// pixels off the mean may be noise. It is accepted after `settled` frames in a row. Two kinds are
/// accepted at once:
/// - a disparity nearer by more than `clearlyNearer`, because an approaching object must not wait;
/// - a disparity of a pixel that had no match for `frames` frames, unless an old surface within
///   `nearby` pixels differs from it by at most `jump`. Such a patch has just gained texture, as at
///   the edge of a shadow, and its first matches are poor.
/// Over space: the mean of the neighbours within `alike` pixels of the centre's disparity, which
/// keeps edges; done twice. A pixel with few such neighbours, but many within `jump`, is noise and
/// loses its disparity.
/// Used by one thread.
class DisparitySmoother {
 public:
  static constexpr float jump = 3.0F;           ///< pixels
  static constexpr float clearlyNearer = 8.0F;  ///< pixels, more than noise
  static constexpr int settled = 5;             ///< frames
  static constexpr int nearby = 30;             ///< pixels, across and down
  static constexpr float alike = 1.0F;          ///< pixels

  /// `disparity`: CV_32FC1, pixels, NaN without a match. `frames`: the newest frame has the weight
  /// 1/frames, or 1/n while there are only n frames; at most 1: returns the input. Forgets all
  /// frames when the size changes.
  cv::Mat overTime(const cv::Mat& disparity, int frames);
  void reset();

  /// `window`: full width, pixels; below 2: returns the input. Pure.
  static cv::Mat overSpace(const cv::Mat& disparity, int window);

 private:
  cv::Mat m_mean;    ///< CV_32FC1
  cv::Mat m_frames;  ///< CV_32FC1: frames in m_mean; below 0, minus the frames without a match
};

}  // namespace boomwatch
