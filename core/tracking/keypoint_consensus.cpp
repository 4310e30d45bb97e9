#include "tracking/keypoint_consensus.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/median.h"
#include "tracking/cmt_tuning.h"

namespace boomwatch {
namespace {

constexpr CmtTuning tuning;

cv::Point2d turned(const cv::Point2d& p, double angle, double scale) {
  const double c = std::cos(angle) * scale, s = std::sin(angle) * scale;
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// The median of angles, around their mean direction: angles have no order across +-pi.
double medianAngle(const std::vector<double>& angles) {
  double x = 0.0, y = 0.0;
  for (const double angle : angles) {
    x += std::cos(angle);
    y += std::sin(angle);
  }
  const double mean = std::atan2(y, x);
  std::vector<double> offsets;
  offsets.reserve(angles.size());
  for (const double angle : angles) {
    offsets.push_back(std::remainder(angle - mean, 2.0 * std::numbers::pi));
  }
  return std::remainder(mean + medianOf(offsets), 2.0 * std::numbers::pi);
}

/// Scale and rotation; the centre is left to the votes.
std::optional<KeypointPose> pairwisePose(const std::vector<KeypointPair>& points) {
  std::vector<double> scales, rotations;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const cv::Point2d before = points[i].model - points[j].model;
      const cv::Point2d now = points[i].position - points[j].position;
      const double length = cv::norm(before), lengthNow = cv::norm(now);
      // Points this close say nothing of either.
      if (length < tuning.minApart || lengthNow < tuning.minApartNow) continue;
      scales.push_back(lengthNow / length);
      rotations.push_back(std::atan2(before.cross(now), before.dot(now)));
    }
  }
  if (scales.empty()) return std::nullopt;
  return KeypointPose{{}, medianOf(scales), medianAngle(rotations)};
}

/// The members of the largest cluster.
std::vector<std::size_t> maxCluster(const std::vector<cv::Point2d>& votes, double reach) {
  std::vector<std::size_t> best, open, free(votes.size());
  std::iota(free.begin(), free.end(), std::size_t{0});
  while (!free.empty()) {
    std::vector<std::size_t> cluster;
    open.assign(1, free.back());
    free.pop_back();
    while (!open.empty()) {
      const std::size_t one = open.back();
      open.pop_back();
      cluster.push_back(one);
      const auto apart = [&](std::size_t other) {
        return cv::norm(votes[one] - votes[other]) > reach;
      };
      const auto near = std::partition(free.begin(), free.end(), apart);
      open.insert(open.end(), near, free.end());
      free.erase(near, free.end());
    }
    if (cluster.size() > best.size()) best = std::move(cluster);
  }
  return best;
}

}  // namespace

cv::Point2d placeOf(const KeypointPose& pose, const cv::Point2d& model) {
  return pose.centre + turned(model, pose.rotation, pose.scale);
}

std::optional<KeypointConsensus> consensusOf(const std::vector<KeypointPair>& points,
                                             double reach) {
  auto pose = pairwisePose(points);
  if (!pose) return std::nullopt;
  std::vector<cv::Point2d> votes;
  for (const KeypointPair& point : points) {
    votes.push_back(point.position - turned(point.model, pose->rotation, pose->scale));
  }
  KeypointConsensus consensus;
  cv::Point2d sum;
  for (const std::size_t index : maxCluster(votes, reach * pose->scale)) {
    sum += votes[index];
    consensus.points.push_back(points[index]);
  }
  pose->centre = sum / static_cast<double>(consensus.points.size());
  consensus.pose = *pose;
  return consensus;
}

}  // namespace boomwatch
