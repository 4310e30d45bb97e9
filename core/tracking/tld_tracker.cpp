#include "tracking/tld_tracker.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <tuple>

#include "base/error.h"
#include "tracking/flow_tuning.h"
#include "tracking/median_flow.h"
#include "tracking/patch_cutter.h"
#include "tracking/refine_box.h"
#include "tracking/tld_tuning.h"

namespace boomwatch {
namespace {
constexpr TldTuning tuning;

double shareInside(const cv::Rect2d& box, cv::Size image) {
  return (box & cv::Rect2d(cv::Point2d(), cv::Size2d(image))).area() / box.area();
}

cv::Rect2d mixed(const cv::Rect2d& box, const cv::Rect2d& other) {
  const auto mix = [](double a, double b) { return a + tuning.mixShare * (b - a); };
  return {mix(box.x, other.x), mix(box.y, other.y), mix(box.width, other.width),
          mix(box.height, other.height)};
}

/// The first of these if it is the only one or leads the others clearly.
std::optional<Detection> clearBest(const std::vector<Detection>& detections) {
  if (detections.empty()) return std::nullopt;
  const bool clear = detections.size() == 1 || detections[0].likeness.relative >
                                                   detections[1].likeness.relative + tuning.lead;
  return clear ? std::optional(detections.front()) : std::nullopt;
}

/// Flow drifts: it takes a little of what is behind the tool along, and goes with the surface of a
/// tool that turns. Keypoints know where they were at the beginning, but some are others.
std::optional<Detection> followedOf(const std::optional<Detection>& flowed,
                                    const std::optional<Detection>& agreed) {
  if (!agreed) return flowed;
  const float likeness = agreed->likeness.conservative;
  if (!flowed) return likeness > tuning.doubtedLikeness ? agreed : std::nullopt;
  const bool same = overlap(flowed->box, agreed->box) >= tuning.sameOverlap;
  const bool better = likeness > flowed->likeness.conservative;
  return better && (same || likeness > tuning.trustedLikeness) ? agreed : flowed;
}

void requireUsable(const ToolModel& model) {
  const cv::Size patch = model.patchSize();
  const auto fits = [&](const cv::Mat& other) {
    return other.type() == CV_8UC1 && other.size() == patch;
  };
  const bool usable =
      !model.positives.empty() && model.positives.size() <= ToolModel::maxPositives &&
      model.negatives.size() <= ToolModel::maxNegatives &&
      model.leaves.size() == ToolModel::ferns * ToolModel::leavesPerFern &&
      std::ranges::all_of(model.positives, fits) && std::ranges::all_of(model.negatives, fits);
  if (usable) return;
  throw Error("tool model", "it knows nothing of a tool", "Begin with a box, and save that model.");
}

}  // namespace

void TldTracker::begin(ToolClassifier tool) {
  m_tool.emplace(std::move(tool));
  m_before.release();
  m_found.reset();
  m_cells = FlowCells();
  m_keypoints = CmtTracker(KeypointReach::DensePart);
  m_trusted = false;
  m_colours = ColourLayout();
  m_recent.forget();
  m_images = 0;
  m_scale = 1.0;
  m_imagesLost = std::numeric_limits<int>::max() / 2;
  m_imagesDoubted = 0;
  m_model.reset();
}

void TldTracker::start(const cv::Mat& image, const cv::Rect2d& box) {
  requireStart(image, box);
  const cv::Mat grey = greyOf(image);
  ToolLearning learning;
  begin(learning.begin(grey, box));
  m_learning = learning;
  try {
    m_keypoints.start(grey, box);
  } catch (const Error&) {
    // There are too few: it is followed without them.
  }
  m_colours.begin(image, box);
  m_before = grey.clone();
  m_found = Detection{box, {1.0F, 1.0F}};
  m_trusted = true;
  m_imagesLost = 0;
}

void TldTracker::start(const ToolModel& model) {
  requireUsable(model);
  begin(ToolClassifier(model));
  m_learning = ToolLearning();
}

/// What lies in `box`, and how much it looks like the tool.
Detection TldTracker::judged(const cv::Mat& grey, const cv::Rect2d& box) const {
  return {box, m_tool->likeness(PatchCutter(grey, box, m_tool->patchSize()).cut())};
}

std::optional<Detection> TldTracker::consensus(const cv::Mat& grey) {
  if (!m_found) return std::nullopt;
  const Track track = m_keypoints.track(grey);
  if (!track.box || std::min(track.box->width, track.box->height) < minSide / 2.0 ||
      shareInside(*track.box, grey.size()) < tuning.minShareInside) {
    return std::nullopt;
  }
  return judged(grey, *track.box);
}

std::optional<Detection> TldTracker::flow(const cv::Mat& grey) {
  if (!m_found || m_before.size() != grey.size()) return std::nullopt;
  const std::optional<MedianFlow> moved = medianFlow(m_before, grey, m_found->box, &m_cells);
  if (!moved || moved->residual > FlowTuning().maxResidual) return std::nullopt;
  if (std::min(moved->box.width, moved->box.height) < minSide / 2.0) return std::nullopt;
  if (shareInside(moved->box, grey.size()) < tuning.minShareInside) return std::nullopt;
  const cv::Rect2d box = moved->similarity < tuning.sureFlow
                             ? refineBox(grey, moved->box, *m_tool, tuning.refinedShare)
                             : moved->box;
  const cv::Mat patch = PatchCutter(grey, box, m_tool->patchSize()).cut();
  if (varianceOf(patch) < tuning.flatShare * m_tool->minVariance()) return std::nullopt;
  return Detection{box, m_tool->likeness(patch)};
}

ScanLevels TldTracker::levelsOf(const cv::Mat& grey) const {
  const int range = m_imagesLost > tuning.imagesAway ? 2 * tuning.allScales : tuning.nearScales;
  const int last = cvRound(std::log(m_scale) / std::log(tuning.scaleStep));
  return {grey, m_tool->toolSize(), m_tool->patchSize(), std::max(-tuning.allScales, last - range),
          std::min(tuning.allScales, last + range)};
}

/// Windows lie a tenth of their size apart, and half of that off a tool can look like something
/// else. The likeliest of those that do are looked at once more, as well placed as can be.
std::vector<Candidate> TldTracker::sharpened(const cv::Mat& grey,
                                             std::vector<Candidate> candidates) const {
  std::ranges::stable_sort(candidates, std::greater(),
                           [](const Candidate& one) { return one.likeness.relative; });
  std::vector<Candidate> places;
  for (const Candidate& candidate : candidates) {
    if (places.size() == tuning.maxSharpened) break;
    const bool isNew = std::ranges::none_of(places, [&](const Candidate& place) {
      return overlap(place.box, candidate.box) >= tuning.sameOverlap;
    });
    if (isNew) places.push_back(candidate);
  }
  for (Candidate place : places) {
    if (place.likeness.relative >= tuning.toolThreshold) continue;
    place.box = refineBox(grey, place.box, *m_tool, 1.0);
    place.likeness = m_tool->likeness(PatchCutter(grey, place.box, m_tool->patchSize()).cut());
    if (place.likeness.conservative > tuning.trustedLikeness) candidates.push_back(place);
  }
  return candidates;
}

std::vector<Detection> TldTracker::detect(const cv::Mat& image, const cv::Mat& grey,
                                          const std::vector<Candidate>& candidates) const {
  std::vector<Detection> detections =
      clusterDetections(m_found ? candidates : sharpened(grey, candidates));
  for (Detection& detection : detections) {
    detection = judged(grey, refineBox(grey, detection.box, *m_tool, 1.0));
  }
  std::erase_if(detections, [&](const Detection& one) { return m_colours.denies(image, one.box); });
  std::ranges::stable_sort(detections, std::greater(),
                           [](const Detection& detection) { return detection.likeness.relative; });
  return detections;
}

bool TldTracker::isSure() const {
  return m_trusted && m_found && m_found->likeness.conservative > tuning.doubtedLikeness;
}

/// Where patches and flow are not sure, the colours say whether the box is on the tool, and where
/// the tool is if it is not there. Where they are, the colours learn how far they can be believed.
void TldTracker::askColours(const cv::Mat& image, const cv::Mat& grey,
                            const std::vector<ColourLayout::Place>& places) {
  const bool sure = isSure();
  const bool here =
      m_found && !places.empty() && overlap(places.front().box, m_found->box) >= tuning.sameOverlap;
  const auto tool = here ? std::nullopt : m_colours.toolIn(image, places);
  const double ahead = sure ? tuning.farAhead : tuning.justAhead;
  if (m_found && tool && m_colours.scoreOf(image, m_found->box) < tool->score - ahead) lose();
  if (!m_found) {
    if (!tool) return;
    m_found = judged(grey, tool->box);
  } else if (sure) {
    m_colours.observe(image, places, m_found->box);
  } else if (m_colours.denies(image, m_found->box)) {
    lose();
  } else if (const auto least = m_colours.threshold();
             least && m_colours.scoreOf(image, m_found->box) >= *least) {
    m_imagesDoubted = 0;
  }
}

/// What looks as the tool did when it was last seen, unless it was learnt as something else or has
/// other colours.
std::optional<Detection> TldTracker::cameBack(const cv::Mat& image, const cv::Mat& grey,
                                              const cv::Rect2d& box) const {
  const Detection place = judged(grey, box);
  const bool other = place.likeness.relative < tuning.somethingElse || m_colours.denies(image, box);
  return other ? std::nullopt : std::optional(place);
}

void TldTracker::lose() {
  m_found.reset();
  m_trusted = false;
  m_imagesDoubted = 0;
}

void TldTracker::reject() {
  lose();
  m_recent.forget();                     // that was something else
  m_imagesLost = tuning.imagesAway + 1;  // and so was its size
}

bool TldTracker::isDisputed(const std::vector<Detection>& detections) const {
  return std::ranges::any_of(detections, [&](const Detection& detection) {
    return overlap(detection.box, m_found->box) < tuning.sameOverlap;
  });
}

/// Section 5.4 of the paper: the flow's box, unless the detector is surer of another place.
void TldTracker::integrate(const cv::Mat& grey, const std::optional<Detection>& followed,
                           const std::vector<Detection>& detections) {
  if (!followed) {
    lose();
    m_found = clearBest(detections);
    return;
  }
  m_found = followed;
  std::vector<Detection> better;
  std::ranges::copy_if(detections, std::back_inserter(better), [&](const Detection& detection) {
    return overlap(detection.box, followed->box) < tuning.sameOverlap &&
           detection.likeness.relative > followed->likeness.relative &&
           detection.likeness.conservative > followed->likeness.conservative;
  });
  if (const std::optional<Detection> best = clearBest(better)) {
    lose();
    m_found = best;
    return;
  }
  if (followed->likeness.conservative > tuning.trustedLikeness) m_trusted = true;
  // In other light than any that was learnt it still looks as it did a moment ago.
  const bool doubted = followed->likeness.relative < tuning.doubtedLikeness &&
                       !m_recent.recognises(grey, followed->box);
  m_imagesDoubted = doubted ? m_imagesDoubted + 1 : 0;
  if (m_imagesDoubted > tuning.maxDoubt) {
    lose();
    return;
  }
  for (const Detection& detection : detections) {
    if (overlap(detection.box, m_found->box) < tuning.mixOverlap) continue;
    m_found->box = mixed(m_found->box, detection.box);
  }
}

bool TldTracker::learn(const cv::Mat& grey, const ScanLevels& levels,
                       const std::vector<Candidate>& candidates) {
  if (!ToolLearning::canLearn(grey, m_found->box, *m_tool)) {
    m_trusted = false;
    return false;
  }
  m_learning.learn(grey, m_found->box, levels, candidates, *m_tool);
  m_model.reset();
  return true;
}

Track TldTracker::track(const cv::Mat& image) {
  if (!m_tool) return Track::idle();
  const bool wasSeen = m_found.has_value();
  bool learnt = false;
  if (isTrackable(image)) {
    const cv::Mat grey = greyOf(image);
    // Followed and looked for at the same time: neither depends on the other.
    auto following = std::async(std::launch::async, [&] {
      const auto back = wasSeen ? std::nullopt : m_recent.find(grey);
      return std::tuple(flow(grey), consensus(grey), back);
    });
    const ScanLevels levels = levelsOf(grey);
    const std::vector<Candidate> candidates = findCandidates(levels, *m_tool);
    const std::vector<Detection> detections = detect(image, grey, candidates);
    // Looked for here already where they will be needed: the keypoints take longer.
    std::optional<std::vector<ColourLayout::Place>> places;
    if (++m_images % tuning.coloursEvery == 0 || !m_trusted) places = m_colours.places(image);
    const auto [flowed, agreed, back] = following.get();
    integrate(grey, followedOf(flowed, agreed), detections);
    if (isSure() && !m_colours.isKnown()) m_colours.begin(image, m_found->box);
    if (!isSure() && !places) places = m_colours.places(image);
    if (places) askColours(image, grey, *places);
    if (!m_found && back) m_found = cameBack(image, grey, *back);
    if (m_found) m_recent.follow();
    if (m_found && m_found->likeness.relative >= tuning.doubtedLikeness) {
      m_recent.remember(grey, m_found->box);
    }
    // What the keypoints carry on must be the tool's.
    if (m_found &&
        !(wasSeen && agreed && overlap(agreed->box, m_found->box) >= tuning.sameOverlap)) {
      m_keypoints.lookAt(m_found->box);
    }
    if (m_learns && m_trusted && !isDisputed(detections)) learnt = learn(grey, levels, candidates);
    m_before = grey.data == image.data ? grey.clone() : grey;
  } else {
    lose();
    m_before.release();
  }
  const LearningState learning = !m_learns ? LearningState::Off
                                 : learnt  ? LearningState::On
                                           : LearningState::Suspended;
  if (!m_found) {
    m_imagesLost = std::min(m_imagesLost, tuning.imagesAway) + 1;
    return {TrackState::Lost, std::nullopt, 0.0, learning};
  }
  m_imagesLost = 0;
  m_scale = std::sqrt(m_found->box.area() / m_tool->toolSize().area());
  return {wasSeen ? TrackState::Tracked : TrackState::Refound, m_found->box,
          m_found->likeness.conservative, learning};
}

std::shared_ptr<const ToolModel> TldTracker::model() const {
  if (!m_tool) return nullptr;
  if (!m_model) m_model = std::make_shared<const ToolModel>(m_tool->model());
  return m_model;
}

}  // namespace boomwatch
