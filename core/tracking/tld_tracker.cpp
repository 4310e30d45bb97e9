#include "tracking/tld_tracker.h"

#include <algorithm>
#include <numbers>

#include "frame/error.h"
#include "tracking/median_flow.h"
#include "tracking/tool_patch.h"

namespace boomwatch {
namespace {

constexpr int scaleRange = 8;
constexpr float trustThreshold = 0.7F;
constexpr double farOverlap = 0.2;

double inside(const cv::Rect2d& box, cv::Size image) {
  return (box & cv::Rect2d(cv::Point2d(), cv::Size2d(image))).area() / box.area();
}

}  // namespace

ScanLevels TldTracker::levelsOf(const cv::Mat& grey) const {
  return ScanLevels(grey, m_tool->toolSize(), m_tool->patchSize(), scaleRange);
}

void TldTracker::learnFerns(const cv::Mat& grey, const cv::Rect2d& box, int warps, double angle) {
  const PatchCutter cutter(grey, box, m_tool->patchSize());
  const auto within = [&](double limit) {
    return limit * (2.0 * m_random() / static_cast<double>(std::mt19937::max()) - 1.0);
  };
  for (int i = 0; i < warps; ++i) {
    const double turn = within(angle);
    const double scale = 1.0 + within(0.1);
    const double right = within(0.07);
    const double down = within(0.07);
    const cv::Mat patch = cutter.cut({turn, scale, {right, down}});
    m_tool->ferns().learn(m_tool->ferns().codesOf(patch), true);
  }
}

void TldTracker::start(const cv::Mat& image, const cv::Rect2d& box) {
  requireStart(image, box);
  const cv::Mat grey = greyOf(image);
  ToolModel empty;
  empty.size = box.size();
  const cv::Mat patch = PatchCutter(grey, box, empty.patchSize()).cut();
  if (varianceOf(patch) < 0.25) {
    throw Error("tool box", "there is nothing in it that could be followed",
                "Draw a box that encloses the tool.");
  }
  m_tool.emplace(empty);
  m_random.seed(1);
  m_tool->learnPositive(patch);
  learnFerns(grey, box, 200, 10.0 * std::numbers::pi / 180.0);
  m_last = grey.clone();
  m_box = box;
  m_likeness = {1.0F, 1.0F};
  m_trusted = true;
  const ScanLevels levels = levelsOf(grey);
  for (int pass = 0; pass < 4; ++pass) {
    for (const Candidate& candidate : findCandidates(levels, *m_tool)) {
      if (overlap(candidate.box, box) >= farOverlap) continue;
      const cv::Mat other = levels.patchOf(candidate.window);
      m_tool->ferns().learn(m_tool->ferns().codesOf(other), false);
      if (m_tool->likeness(other).relative > 0.5F) m_tool->learnNegative(other);
    }
  }
  m_model.reset();
}

void TldTracker::start(const ToolModel& model) {
  m_tool.emplace(model);
  m_random.seed(1);
  m_last.release();
  m_box.reset();
  m_likeness = {};
  m_trusted = false;
  m_model.reset();
}

std::optional<TldTracker::Followed> TldTracker::follow(const cv::Mat& grey) const {
  if (!m_box || m_last.size() != grey.size()) return std::nullopt;
  const std::optional<MedianFlow> step = medianFlow(m_last, grey, *m_box);
  if (!step || step->residual > 10.0) return std::nullopt;
  if (std::min(step->box.width, step->box.height) < 4.0) return std::nullopt;
  if (inside(step->box, grey.size()) < 0.5) return std::nullopt;
  const cv::Mat patch = PatchCutter(grey, step->box, m_tool->patchSize()).cut();
  return Followed{step->box, m_tool->likeness(patch)};
}

void TldTracker::integrate(const std::optional<Followed>& followed,
                           const std::vector<Detection>& detections) {
  if (!followed) {
    m_trusted = false;
    m_box.reset();
    m_likeness = {};
    if (detections.size() == 1) {
      m_box = detections.front().box;
      m_likeness = detections.front().likeness;
    }
    return;
  }
  m_box = followed->box;
  m_likeness = followed->likeness;
  if (m_likeness.conservative > trustThreshold) m_trusted = true;
  std::vector<Detection> better;
  for (const Detection& detection : detections) {
    if (overlap(detection.box, *m_box) < 0.5 &&
        detection.likeness.conservative > m_likeness.conservative) {
      better.push_back(detection);
    }
  }
  if (better.size() == 1) {
    m_box = better.front().box;
    m_likeness = better.front().likeness;
    m_trusted = false;
    return;
  }
  for (const Detection& detection : detections) {
    if (overlap(detection.box, *m_box) < 0.7) continue;
    const auto mix = [](double a, double b) { return (10.0 * a + 3.0 * b) / 13.0; };
    m_box = cv::Rect2d(mix(m_box->x, detection.box.x), mix(m_box->y, detection.box.y),
                       mix(m_box->width, detection.box.width),
                       mix(m_box->height, detection.box.height));
  }
}

void TldTracker::learn(const cv::Mat& grey, const std::vector<Candidate>& candidates) {
  const cv::Mat patch = PatchCutter(grey, *m_box, m_tool->patchSize()).cut();
  const Likeness likeness = m_tool->likeness(patch);
  if (likeness.relative < 0.5F || varianceOf(patch) < m_tool->leastVariance()) {
    m_trusted = false;
    return;
  }
  learnFerns(grey, *m_box, 20, 5.0 * std::numbers::pi / 180.0);
  if (likeness.relative < 0.65F) m_tool->learnPositive(patch);
  const ScanLevels levels = levelsOf(grey);
  for (const Candidate& candidate : candidates) {
    if (overlap(candidate.box, *m_box) >= farOverlap) continue;
    const cv::Mat other = levels.patchOf(candidate.window);
    m_tool->ferns().learn(m_tool->ferns().codesOf(other), false);
    if (m_tool->likeness(other).relative > 0.5F) m_tool->learnNegative(other);
  }
  m_model.reset();
}

Track TldTracker::track(const cv::Mat& image) {
  if (!m_tool) return Track::idle();
  if (!isTrackable(image)) {
    m_box.reset();
    m_last.release();
    return Track::lost();
  }
  const cv::Mat grey = greyOf(image);
  const bool wasSeen = m_box.has_value();
  const std::optional<Followed> followed = follow(grey);
  const std::vector<Candidate> candidates = findCandidates(levelsOf(grey), *m_tool);
  integrate(followed, clusterDetections(candidates));
  const bool learning = m_learning && m_box && m_trusted;
  if (learning) learn(grey, candidates);
  m_last = grey.data == image.data ? grey.clone() : grey;
  return result(learning, wasSeen);
}

Track TldTracker::result(bool learnt, bool wasSeen) const {
  Track track;
  track.state = !m_box ? TrackState::Lost : wasSeen ? TrackState::Tracked : TrackState::Refound;
  track.box = m_box;
  track.confidence = m_box ? m_likeness.conservative : 0.0;
  track.learning = !m_learning ? LearningState::Off
                   : learnt    ? LearningState::On
                               : LearningState::Suspended;
  return track;
}

std::shared_ptr<const ToolModel> TldTracker::model() const {
  if (!m_tool) return nullptr;
  if (!m_model) m_model = std::make_shared<const ToolModel>(m_tool->model());
  return m_model;
}

}  // namespace boomwatch
