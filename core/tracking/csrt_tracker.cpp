#include "tracking/csrt_tracker.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/tracking.hpp>
#include <utility>

#include "frame/error.h"

namespace boomwatch {
namespace {

// Measured over seven recordings with ground truth: of the boxes that lie on the target 1 in 100 is
// less similar than this, of those beside it 9 in 10 are.
constexpr double smallestSimilarity = 0.25;
constexpr double smallestContrast = 2.0;  // grey levels
const cv::Size patchSize(24, 24);

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

cv::Mat histogramOf(const cv::Mat& image) {
  cv::Mat pixels = image, histogram;
  if (image.channels() == 3) cv::cvtColor(image, pixels, cv::COLOR_BGR2HSV);
  const bool grey = pixels.channels() == 1;
  const float hues[] = {0.0F, 180.0F}, levels[] = {0.0F, 256.0F};
  const float* ranges[] = {grey ? levels : hues, levels, levels};
  const int channels[] = {0, 1, 2};
  const int bins[] = {8, 6, 8};
  cv::calcHist(&pixels, 1, channels, cv::noArray(), histogram, grey ? 1 : 3, bins, ranges);
  return histogram / static_cast<double>(image.total());
}

}  // namespace

CsrtTracker::Appearance CsrtTracker::appearanceOf(const cv::Mat& image, const cv::Rect& box) {
  Appearance appearance;
  const cv::Mat inside = image(box);
  cv::resize(greyOf(inside), appearance.patch, patchSize, 0.0, 0.0, cv::INTER_AREA);
  appearance.histogram = histogramOf(inside);
  return appearance;
}

double CsrtTracker::similarity(const Appearance& now) const {
  cv::Mat ncc, common;
  cv::matchTemplate(now.patch, m_first.patch, ncc, cv::TM_CCOEFF_NORMED);
  cv::min(now.histogram, m_first.histogram, common);
  const double pattern = std::clamp<double>(ncc.at<float>(0), 0.0, 1.0);
  return (pattern + std::min(cv::sum(common)[0], 1.0)) / 2.0;
}

void CsrtTracker::start(const cv::Mat& image, const cv::Rect2d& box) {
  requireStart(image, box);
  const cv::Rect rounded = cv::Rect(box) & cv::Rect({}, image.size());
  if (contrastOf(greyOf(image(rounded))) < smallestContrast) {
    throw Error("tool box", "there is nothing in it to follow: it has no texture",
                "Draw it around a part with edges or corners.");
  }
  auto engine = cv::TrackerCSRT::create();
  try {
    engine->init(image, rounded);
  } catch (const cv::Exception&) {
    throw Error("tool box", "OpenCV's CSRT cannot begin with it", "Draw another box.");
  }
  m_engine = engine;
  m_first = appearanceOf(image, rounded);
  m_size = image.size();
  m_channels = image.channels();
  m_seen = true;
}

Track CsrtTracker::track(const cv::Mat& image) {
  if (!m_engine) return Track::idle();
  cv::Rect box;
  double confidence = 0.0;
  try {
    // An image without contrast would only teach it darkness.
    if (isTrackable(image) && image.size() == m_size &&
        contrastOf(greyOf(image)) >= smallestContrast) {
      const cv::Mat fitting = withChannels(image, m_channels);
      const bool located = m_engine->update(fitting, box);
      const cv::Rect inside = box & cv::Rect({}, image.size());
      if (located && !inside.empty()) confidence = similarity(appearanceOf(fitting, inside));
    }
  } catch (const cv::Exception&) {
    confidence = 0.0;
  }
  const bool seenBefore = std::exchange(m_seen, confidence >= smallestSimilarity);
  if (!m_seen) return Track::lost();
  return {seenBefore ? TrackState::Tracked : TrackState::Refound, cv::Rect2d(box), confidence,
          LearningState::None};
}

}  // namespace boomwatch
