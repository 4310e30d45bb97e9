#include "tracking/klt_tracker.h"

#include <algorithm>

#include "base/error.h"
#include "tracking/flow_tuning.h"
#include "tracking/median_flow.h"

namespace boomwatch {
namespace {
constexpr FlowTuning tuning;

bool isCredible(const MedianFlow& flow, cv::Size image) {
  const cv::Rect2d inside = flow.box & cv::Rect2d(0, 0, image.width, image.height);
  return flow.residual <= tuning.maxResidual && flow.similarity >= tuning.minSimilarity &&
         std::min(flow.box.width, flow.box.height) >= Tracker::minSide / 2 &&
         inside.area() >= tuning.minShareInside * flow.box.area();
}

}  // namespace

void KltTracker::start(const cv::Mat& image, const cv::Rect2d& box) {
  requireStart(image, box);
  const cv::Mat grey = greyOf(image);
  if (!medianFlow(grey, grey, box)) {
    throw Error("tool box", "there is nothing in it to follow: it has no texture",
                "Draw it around a part with edges or corners.");
  }
  m_before = grey.clone();
  m_box = box;
  m_started = true;
}

Track KltTracker::track(const cv::Mat& image) {
  if (!m_started) return Track::idle();
  if (m_before.empty()) return Track::lost();
  const auto flow = isTrackable(image) && image.size() == m_before.size()
                        ? medianFlow(m_before, greyOf(image), m_box)
                        : std::nullopt;
  if (!flow || !isCredible(*flow, image.size())) {
    m_before.release();
    return Track::lost();
  }
  m_before = greyOf(image).clone();
  m_box = flow->box;
  return {TrackState::Tracked, m_box, std::min(flow->similarity, 1.0), LearningState::None};
}

}  // namespace boomwatch
