#pragma once

#include <opencv2/core.hpp>
#include <opencv2/video/tracking.hpp>

#include "tracking/tracker.h"

namespace boomwatch {

/// OpenCV's CSRT (Lukezic et al., "Discriminative Correlation Filter with Channel and Spatial
/// Reliability", IJCV 2018).
///
/// OpenCV says where the target is most likely, not how likely it is there at all, and keeps
/// learning whatever is there. The confidence is therefore ours: how alike the box's content is to
/// what it began with, half by its pattern (NCC) and half by its colours (histogram intersection).
/// It looks only around the place where it was last, and finds the target again only there.
class CsrtTracker : public Tracker {
 public:
  using Tracker::start;
  void start(const cv::Mat& image, const cv::Rect2d& box) override;
  Track track(const cv::Mat& image) override;

 private:
  /// What the target looked like when it was pointed at.
  struct Appearance {
    cv::Mat patch;      ///< CV_8UC1
    cv::Mat histogram;  ///< of hue, saturation and value, or of grey; its sum is 1
  };
  static Appearance appearanceOf(const cv::Mat& image, const cv::Rect& box);
  double similarity(const Appearance& now) const;

  cv::Ptr<cv::Tracker> m_engine;
  Appearance m_first;
  cv::Size m_size;      ///< of the images
  int m_channels = 0;   ///< of the images
  bool m_seen = false;  ///< in the image before
};

}  // namespace boomwatch
