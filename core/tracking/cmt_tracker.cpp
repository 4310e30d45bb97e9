#include "tracking/cmt_tracker.h"

#include <algorithm>
#include <cmath>
#include <future>
#include <numeric>
#include <opencv2/core/hal/hal.hpp>
#include <opencv2/features2d.hpp>

#include "base/error.h"
#include "tracking/box_flow.h"
#include "tracking/cmt_tuning.h"

namespace boomwatch {
namespace {

constexpr CmtTuning tuning;
const cv::Size window(tuning.window, tuning.window);

/// In the ellipse that fills the box: what lies in the box's corners is seldom the target.
bool isInEllipse(const cv::Rect2d& box, const cv::Point2d& point) {
  const cv::Point2d off = point - (box.tl() + box.br()) * 0.5;
  return std::hypot(2.0 * off.x / box.width, 2.0 * off.y / box.height) <= 1.0;
}

/// Where the target can be in the next image.
cv::Rect2d grown(const cv::Rect2d& box) {
  const double share = tuning.grown, scale = 1.0 + 2.0 * share;
  return {box.x - share * box.width, box.y - share * box.height, scale * box.width,
          scale * box.height};
}

}  // namespace

void CmtTracker::start(const cv::Mat& image, const cv::Rect2d& box) {
  requireStart(image, box);
  const cv::Mat grey = greyOf(image);
  const KeypointFeatures seen =
      keypointsOf(grey, m_reach == KeypointReach::DensePart ? grown(box) : box, m_reach);
  std::vector<int> order(seen.positions.size());
  std::iota(order.begin(), order.end(), 0);
  // The target's points first.
  const auto background = std::stable_partition(order.begin(), order.end(), [&](int i) {
    return isInEllipse(box, seen.positions[static_cast<std::size_t>(i)]);
  });
  const auto size = static_cast<std::size_t>(background - order.begin());
  if (size < tuning.minModelPoints) {
    throw Error("tool box", "there are too few corners in it to follow",
                "Draw it around a part with more texture, or choose another tracker.");
  }
  const cv::Point2d centre = (box.tl() + box.br()) * 0.5;
  m_size = box.size();
  m_known.clear();
  m_model.clear();
  m_active.clear();
  m_descriptors = cv::Mat(static_cast<int>(order.size()), seen.descriptors.cols, CV_8UC1);
  for (const int index : order) {
    const cv::Point2d position = seen.positions[static_cast<std::size_t>(index)];
    const int row = static_cast<int>(m_known.size());
    seen.descriptors.row(index).copyTo(m_descriptors.row(row));
    m_known.push_back(position);
    if (m_model.size() == size) continue;
    m_model.push_back(position - centre);
    m_active.push_back({row, position - centre, position});
  }
  m_before = grey.clone();
  m_box = box;
}

/// Adaptive correspondences: where the points of the image before have gone.
std::vector<KeypointPair> CmtTracker::followed(const cv::Mat& grey) const {
  if (m_active.empty() || m_before.size() != grey.size()) return {};
  const cv::Rect part = flowRegion(m_box, grey.size());
  if (part.width < window.width || part.height < window.height) return {};
  const cv::Point2d origin(part.tl());
  std::vector<cv::Point2f> before;
  for (const KeypointPair& point : m_active) before.emplace_back(point.position - origin);
  std::vector<KeypointPair> points;
  for (const FollowedPoint& point : followInside(m_before(part), grey(part), before, window)) {
    if (point.error > tuning.maxReturn) continue;
    const KeypointPair& active = m_active[point.index];
    points.push_back({active.id, active.model, cv::Point2d(point.position) + origin});
  }
  return points;
}

/// Corners of an image that resemble one of the target's: few do, and only these need be compared
/// with the background as well.
std::vector<int> CmtTracker::alike(const KeypointFeatures& seen) const {
  const cv::Mat target = m_descriptors.rowRange(0, static_cast<int>(m_model.size()));
  std::vector<cv::DMatch> matches;
  cv::BFMatcher(cv::NORM_HAMMING).match(seen.descriptors, target, matches);
  std::vector<int> rows;
  for (const cv::DMatch& match : matches) {
    if (match.distance <= tuning.maxDistance) rows.push_back(match.queryIdx);
  }
  return rows;
}

/// Static correspondences: what of the first image's target is seen, wherever it is.
std::vector<KeypointPair> CmtTracker::matched(const KeypointFeatures& seen) const {
  const std::vector<int> rows = alike(seen);
  cv::Mat descriptors;
  for (const int row : rows) descriptors.push_back(seen.descriptors.row(row));
  std::vector<std::vector<cv::DMatch>> matches;
  cv::BFMatcher(cv::NORM_HAMMING).knnMatch(descriptors, m_descriptors, matches, tuning.rivals);
  std::vector<const cv::DMatch*> best(m_model.size(), nullptr);
  for (const auto& nearest : matches) {
    if (nearest.empty() || nearest.front().distance > tuning.maxDistance) continue;
    const cv::DMatch& first = nearest.front();
    const auto id = static_cast<std::size_t>(first.trainIdx);
    if (id >= m_model.size()) continue;
    const auto rival = std::find_if(nearest.begin() + 1, nearest.end(), [&](const cv::DMatch& m) {
      return cv::norm(m_known[static_cast<std::size_t>(m.trainIdx)] - m_known[id]) >
             tuning.sameSpot;
    });
    if (rival != nearest.end() && first.distance > tuning.matchRatio * rival->distance) continue;
    if (!best[id] || first.distance < best[id]->distance) best[id] = &first;
  }
  std::vector<KeypointPair> points;
  for (const cv::DMatch* match : best) {
    if (!match) continue;
    points.push_back({match->trainIdx, m_model[static_cast<std::size_t>(match->trainIdx)],
                      seen.positions[static_cast<std::size_t>(
                          rows[static_cast<std::size_t>(match->queryIdx)])]});
  }
  return points;
}

/// Once it is known where the target is, its other points need only be unlike the few around them.
void CmtTracker::addNear(const KeypointFeatures& seen, KeypointConsensus& consensus) const {
  std::vector<bool> known(m_model.size(), false);
  for (const KeypointPair& point : consensus.points) {
    known[static_cast<std::size_t>(point.id)] = true;
  }
  const double limit = reach() * consensus.pose.scale;
  for (std::size_t id = 0; id < m_model.size(); ++id) {
    if (known[id]) continue;
    const cv::Point2d place = placeOf(consensus.pose, m_model[id]);
    int nearest = tuning.maxDistance;
    std::optional<cv::Point2d> position;
    for (std::size_t i = 0; i < seen.positions.size(); ++i) {
      const cv::Point2d off = seen.positions[i] - place;
      if (off.dot(off) > limit * limit) continue;
      const int distance =
          cv::hal::normHamming(seen.descriptors.ptr(static_cast<int>(i)),
                               m_descriptors.ptr(static_cast<int>(id)), m_descriptors.cols);
      if (distance >= nearest) continue;
      nearest = distance;
      position = seen.positions[i];
    }
    if (position) consensus.points.push_back({static_cast<int>(id), m_model[id], *position});
  }
}

double CmtTracker::reach() const {
  return std::min(tuning.maxReach, tuning.reachShare * std::sqrt(m_size.area()));
}

cv::Rect2d CmtTracker::boxAt(const KeypointPose& pose) const {
  const double c = std::cos(pose.rotation), s = std::sin(pose.rotation);
  const double width = pose.scale * std::hypot(m_size.width * c, m_size.height * s);
  const double height = pose.scale * std::hypot(m_size.width * s, m_size.height * c);
  return {pose.centre.x - width / 2, pose.centre.y - height / 2, width, height};
}

bool CmtTracker::isCredible(const KeypointConsensus& consensus, cv::Size image) const {
  const double needed = std::max({static_cast<double>(tuning.minAgreeing),
                                  tuning.minShare * static_cast<double>(m_model.size()),
                                  tuning.minSurvival * static_cast<double>(m_active.size())});
  const cv::Rect2d box = boxAt(consensus.pose);
  const bool sized =
      consensus.pose.scale > 1.0 / tuning.maxScale && consensus.pose.scale < tuning.maxScale;
  return sized && static_cast<double>(consensus.points.size()) >= needed &&
         !(box & cv::Rect2d(0, 0, image.width, image.height)).empty();
}

void CmtTracker::lookAt(const cv::Rect2d& box) {
  m_box = box;
  m_active.clear();
  m_before.release();
}

Track CmtTracker::track(const cv::Mat& image) {
  if (m_model.empty()) return Track::idle();
  const bool seenBefore = !m_before.empty();
  const bool isNear = seenBefore || m_reach == KeypointReach::DensePart;
  std::optional<KeypointConsensus> consensus;
  cv::Mat grey;
  if (isTrackable(image)) {
    grey = greyOf(image);
    auto following = std::async(std::launch::async, [&] { return followed(grey); });
    const KeypointFeatures seen = isNear
                                      ? keypointsOf(grey, grown(m_box), KeypointReach::DensePart)
                                      : keypointsOf(grey, cv::Rect2d(), KeypointReach::Everywhere);
    std::vector<KeypointPair> points = matched(seen);
    for (const KeypointPair& point : following.get()) {
      if (std::ranges::find(points, point.id, &KeypointPair::id) == points.end()) {
        points.push_back(point);
      }
    }
    consensus = consensusOf(points, reach());
    if (consensus && isCredible(*consensus, image.size())) {
      addNear(seen, *consensus);
    } else {
      consensus.reset();
    }
  }
  if (!consensus) {
    m_active.clear();
    m_before.release();
    return Track::lost();
  }
  m_active = consensus->points;
  m_box = boxAt(consensus->pose);
  m_before = grey.clone();
  const double share = static_cast<double>(m_active.size()) / static_cast<double>(m_model.size());
  return {seenBefore ? TrackState::Tracked : TrackState::Refound, m_box, std::min(share, 1.0),
          LearningState::None};
}

}  // namespace boomwatch
