#pragma once

#include <functional>
#include <opencv2/core.hpp>

#include "tracking/tracker.h"

namespace cv::legacy {
inline namespace tracking {
class Tracker;
}
}  // namespace cv::legacy

namespace boomwatch {

/// One of OpenCV's own trackers as it comes, to measure ours against: its box, no confidence (0).
class OpencvTracker : public Tracker {
 public:
  using Engine = cv::Ptr<cv::legacy::Tracker>;

  explicit OpencvTracker(std::function<Engine()> create) : m_create(std::move(create)) {}

  using Tracker::start;
  void start(const cv::Mat& image, const cv::Rect2d& box) override;
  Track track(const cv::Mat& image) override;

 private:
  std::function<Engine()> m_create;
  Engine m_engine;
  cv::Size m_size;  ///< of the image it was started in
  bool m_seen = false;
};

}  // namespace boomwatch
