#include "tracking/csrt_tracker.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/tracking.hpp>
#include <utility>

#include "base/error.h"
#include "tracking/csrt_tuning.h"

namespace boomwatch {
namespace {
constexpr CsrtTuning tuning;
const cv::Size viewSize(tuning.viewSide, tuning.viewSide);

double contrastOf(const cv::Mat& grey) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(grey, mean, deviation);
  return deviation[0];
}

cv::Mat withChannels(const cv::Mat& image, int channels) {
  if (image.channels() == channels) return image;
  cv::Mat result;
  cv::cvtColor(image, result, channels == 3 ? cv::COLOR_GRAY2BGR : cv::COLOR_BGR2GRAY);
  return result;
}

cv::Mat viewOf(const cv::Mat& image, const cv::Rect& box) {
  cv::Mat view;
  cv::resize(greyOf(image(box)), view, viewSize, 0.0, 0.0, cv::INTER_AREA);
  return view;
}

}  // namespace

void CsrtTracker::start(const cv::Mat& image, const cv::Rect2d& box) {
  requireStart(image, box);
  const cv::Rect rounded = cv::Rect(box) & cv::Rect({}, image.size());
  if (contrastOf(greyOf(image(rounded))) < tuning.minContrast) {
    throw Error("tool box", "there is nothing in it to follow: it has no texture",
                "Draw it around a part with edges or corners.");
  }
  const auto engine = cv::TrackerCSRT::create();
  try {
    engine->init(image, rounded);
  } catch (const cv::Exception&) {
    throw Error("tool box", "OpenCV's CSRT cannot begin with it", "Draw another box.");
  }
  m_engine = engine;
  m_views.assign(1, viewOf(image, rounded));
  m_replace = 0;
  m_size = image.size();
  m_channels = image.channels();
  m_seen = true;
  m_isRejected = false;
}

double CsrtTracker::confidenceIn(const cv::Mat& image, const cv::Rect& box) {
  const cv::Rect inside = box & cv::Rect({}, image.size());
  if (inside.empty()) return 0.0;
  const cv::Mat view = viewOf(image, inside);
  double confidence = 0.0;
  for (const cv::Mat& known : m_views) {
    cv::Mat ncc;
    cv::matchTemplate(view, known, ncc, cv::TM_CCOEFF_NORMED);
    confidence = std::max<double>(confidence, ncc.at<float>(0));
  }
  if (confidence >= tuning.surelyTarget && confidence < tuning.sameView) keepView(view);
  return std::min(confidence, 1.0);
}

void CsrtTracker::keepView(const cv::Mat& view) {
  if (m_views.size() < tuning.maxViews) {
    m_views.push_back(view);
    return;
  }
  // The first view stays: it is the only one that a person pointed at.
  m_replace = m_replace % (tuning.maxViews - 1) + 1;
  m_views[m_replace] = view;
}

Track CsrtTracker::track(const cv::Mat& image) {
  if (!m_engine) return Track::idle();
  if (m_isRejected) return Track::lost();
  cv::Rect box;
  double confidence = 0.0;
  try {
    // An image without contrast would only teach it darkness.
    if (isTrackable(image) && image.size() == m_size &&
        contrastOf(greyOf(image)) >= tuning.minContrast) {
      const cv::Mat fitting = withChannels(image, m_channels);
      if (m_engine->update(fitting, box)) confidence = confidenceIn(fitting, box);
    }
  } catch (const cv::Exception&) {
    confidence = 0.0;
  }
  const bool seenBefore = std::exchange(m_seen, confidence >= tuning.minConfidence);
  if (!m_seen) return Track::lost();
  return {seenBefore ? TrackState::Tracked : TrackState::Refound, cv::Rect2d(box), confidence,
          LearningState::None};
}

}  // namespace boomwatch
