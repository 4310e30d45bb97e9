#pragma once

#include "tracking/tracker.h"

namespace boomwatch {

/// Follows the target from image to image by median flow (see median_flow.h) alone.
///
/// It knows nothing of what the target looks like: it cannot find it again, so that after Lost it
/// stays lost until it is started anew, and it can drift without noticing. Its confidence is how
/// alike the points' surroundings are in two successive images (NCC), not how alike the box is to
/// the one it began with.
class KltTracker : public Tracker {
 public:
  using Tracker::start;
  void start(const cv::Mat& image, const cv::Rect2d& box) override;
  Track track(const cv::Mat& image) override;
  void reject() override { m_before.release(); }
  bool hasGivenUp() const override { return m_started && m_before.empty(); }

 private:
  cv::Mat m_before;  ///< CV_8UC1; empty when lost or not started
  cv::Rect2d m_box;  ///< in m_before
  bool m_started = false;
};

}  // namespace boomwatch
