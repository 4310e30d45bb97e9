#pragma once

#include <opencv2/core.hpp>
#include <opencv2/video/tracking.hpp>
#include <vector>

#include "tracking/tracker.h"

namespace boomwatch {

/// OpenCV's CSRT (Lukezic et al., "Discriminative Correlation Filter with Channel and Spatial
/// Reliability", IJCV 2018).
///
/// OpenCV says where the target is most likely, not how likely it is there at all, and goes on
/// learning whatever is there. The confidence is therefore ours: the NCC of the box's content with
/// the most similar of the views seen before, a view being kept when it is like a known one but not
/// the same. It notices when the target is covered or gone at once, not when the box slides off
/// slowly. It looks only around the place where it was last, and finds the target again only there.
class CsrtTracker : public Tracker {
 public:
  using Tracker::start;
  void start(const cv::Mat& image, const cv::Rect2d& box) override;
  Track track(const cv::Mat& image) override;
  /// It would go on around the wrong place: it stays lost.
  void reject() override { m_isRejected = true; }
  bool hasGivenUp() const override { return m_isRejected; }

 private:
  double confidenceIn(const cv::Mat& image, const cv::Rect& box);
  void keepView(const cv::Mat& view);

  cv::Ptr<cv::Tracker> m_engine;
  std::vector<cv::Mat> m_views;  ///< CV_8UC1, of one size; the first is the one it began with
  std::size_t m_replace = 0;     ///< the view that goes next, once there are enough
  cv::Size m_size;               ///< of the images
  int m_channels = 0;            ///< of the images
  bool m_seen = false;           ///< in the image before
  bool m_isRejected = false;     ///< since it was started
};

}  // namespace boomwatch
