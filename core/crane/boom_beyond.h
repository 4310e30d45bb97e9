#pragma once

#include <optional>

#include "crane/beam.h"
#include "frame/cloud.h"

namespace boomwatch {

/// Finds the main boom when the elbow is outside the picture. The jib, which holds the tool, and
/// the main boom are then two clusters of the cloud. Camera frame, metres. Const; any thread.
class BoomBeyond {
 public:
  /// `seen`: points of the tool's cluster without tool and load, that is the jib. isPart() is
  /// always false when the jib is not straight, or without the camera that measured the points.
  BoomBeyond(const Points& seen, const std::optional<PinholeCamera>& camera);

  /// Whether `cluster` is the main boom: it is straight, its axis meets the jib's axis outside the
  /// picture, and both end at the edge of the picture. A tree forms one cluster with the ground, so
  /// it is not straight. The axes of unrelated objects do not meet.
  bool isPart(const Points& cluster) const;

 private:
  bool leavesPicture(const Beam& beam, const Eigen::Vector3d& towards) const;

  std::optional<PinholeCamera> m_camera;
  std::optional<Beam> m_jib;
};

/// Second moments of points, from which the length and width of a cluster follow.
class Spread {
 public:
  void add(const Eigen::Vector3f& p);
  /// A cheap test before BoomBeyond::isPart. It may pass a cluster that is not straight.
  bool mayBeStraight() const;

 private:
  double m_count = 0.0;
  Eigen::Vector3d m_sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d m_squares = Eigen::Matrix3d::Zero();
};

}  // namespace boomwatch
