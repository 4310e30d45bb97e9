#pragma once

#include <vector>

#include "tracking/keypoint_consensus.h"
#include "tracking/keypoint_features.h"
#include "tracking/tracker.h"

namespace boomwatch {

/// Follows the target's keypoints: Nebehay and Pflugfelder, "Consensus-based Matching and Tracking
/// of Keypoints", WACV 2014, and "Clustering of Static-Adaptive Correspondences for Deformable
/// Object Tracking", CVPR 2015.
///
/// What the target looks like is taken from the first image alone (static: descriptors, against
/// those of the background) and carried on from image to image (adaptive: Lucas-Kanade); the points
/// vote for the centre. Unlike in the papers, a target that was seen in the image before is looked
/// for around that place alone: corners from elsewhere only mislead the vote. It follows turns and
/// changes of size in the image plane, and finds the target again anywhere in the image as long as
/// it looks as it did at the beginning. The box is the one around the turned and scaled ellipse
/// that filled the first box: a square stays one, and a rectangle stands upright after a quarter
/// turn. The confidence is the share of the target's keypoints that agree.
class CmtTracker : public Tracker {
 public:
  explicit CmtTracker(KeypointReach reach = KeypointReach::Everywhere) : m_reach(reach) {}

  using Tracker::start;
  void start(const cv::Mat& image, const cv::Rect2d& box) override;
  Track track(const cv::Mat& image) override;
  void reject() override { lookAt(m_box); }

  /// Where it was seen last, as somebody else knows: what was carried on from the image before is
  /// forgotten. With KeypointReach::DensePart the target is looked for there alone.
  void lookAt(const cv::Rect2d& box);

 private:
  std::vector<KeypointPair> followed(const cv::Mat& grey) const;
  std::vector<int> alike(const KeypointFeatures& seen) const;
  std::vector<KeypointPair> matched(const KeypointFeatures& seen) const;
  void addNear(const KeypointFeatures& seen, KeypointConsensus& consensus) const;
  cv::Rect2d boxAt(const KeypointPose& pose) const;
  double reach() const;
  bool isCredible(const KeypointConsensus& consensus, cv::Size image) const;

  KeypointReach m_reach;
  cv::Size2d m_size;                   ///< of the box it began with
  std::vector<cv::Point2d> m_model;    ///< the target's points, from its centre
  std::vector<cv::Point2d> m_known;    ///< places of m_descriptors in the first image
  cv::Mat m_descriptors;               ///< of the target's points, then of the background's
  cv::Mat m_before;                    ///< the image before, CV_8UC1; empty when it was lost there
  std::vector<KeypointPair> m_active;  ///< in m_before
  cv::Rect2d m_box;                    ///< where it was seen last
};

}  // namespace boomwatch
