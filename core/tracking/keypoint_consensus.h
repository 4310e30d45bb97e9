#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace boomwatch {

/// One point of the target: where it was in it, and where it is seen now.
struct KeypointPair {
  int id = 0;            ///< which of the target's points
  cv::Point2d model;     ///< from the target's centre when it was begun, pixels
  cv::Point2d position;  ///< now, pixels
};

/// How the target lies in the image against how it was begun.
struct KeypointPose {
  cv::Point2d centre;  ///< pixels
  double scale = 1.0;
  double rotation = 0.0;  ///< radians, from x to y
};

/// Where a point of the target must be, pixels.
cv::Point2d placeOf(const KeypointPose& pose, const cv::Point2d& model);

/// The pose that most of the points agree on, and the points that do: Nebehay and Pflugfelder,
/// "Consensus-based Matching and Tracking of Keypoints", WACV 2014. Scale and rotation are the
/// medians over all pairs of points; each point then votes for the centre, votes at most `reach`
/// times the scale pixels apart are one cluster (single link), and the largest cluster is the
/// consensus. Absent for less than two different points. Costs the square of their number.
struct KeypointConsensus {
  KeypointPose pose;
  std::vector<KeypointPair> points;
};
std::optional<KeypointConsensus> consensusOf(const std::vector<KeypointPair>& points, double reach);

}  // namespace boomwatch
