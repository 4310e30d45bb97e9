#include "lab/evaluation/opencv_tracker.h"

#include <opencv2/tracking.hpp>
#include <opencv2/tracking/tracking_legacy.hpp>

#include "base/error.h"

namespace boomwatch {

void OpencvTracker::start(const cv::Mat& image, const cv::Rect2d& box) {
  requireStart(image, box);
  try {
    Engine engine = m_create();
    if (!engine->init(image, box)) throw cv::Exception();
    m_engine = engine;
  } catch (const cv::Exception&) {
    throw Error("tool box", "OpenCV cannot begin with it", "Draw another box.");
  }
  m_size = image.size();
  m_seen = true;
}

Track OpencvTracker::track(const cv::Mat& image) {
  if (!m_engine) return Track::idle();
  cv::Rect2d box;
  bool seen = false;
  try {
    seen = isTrackable(image) && image.size() == m_size && m_engine->update(image, box);
  } catch (const cv::Exception&) {
    // What an image does to it is part of what is measured.
  }
  const TrackState state = m_seen ? TrackState::Tracked : TrackState::Refound;
  m_seen = seen;
  if (!seen) return Track::lost();
  return {state, box, 0.0, LearningState::None};
}

}  // namespace boomwatch
