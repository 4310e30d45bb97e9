#pragma once

#include <optional>

#include "crane/beam.h"
#include "frame/cloud.h"

namespace boomwatch {

/// Finds the rest of a boom whose elbow is out of the picture, so that the part which holds the
/// tool and the part on which that hangs are two things in the cloud. Camera frame, metres. Const;
/// any thread.
class BoomBeyond {
 public:
  /// `seen`: points of the boom that hang together with the tool, without tool and load. Finds
  /// nothing without the camera that saw them, or where no part of the boom is straight.
  BoomBeyond(const Points& seen, const std::optional<PinholeCamera>& camera);

  /// Whether `piece`, a cluster, is straight, and its axis meets that of the boom out of the
  /// picture, at whose edge both end. Trees and stumps are not straight together with the ground
  /// they stand on, and axes of things that do not belong together pass by each other.
  bool isPart(const Points& piece) const;

 private:
  bool leavesPicture(const Beam& beam, const Eigen::Vector3d& towards) const;

  std::optional<PinholeCamera> m_camera;
  std::optional<Beam> m_jib;
};

/// Second moments of points: how long and how wide what they cover is.
class Spread {
 public:
  void add(const Eigen::Vector3f& p);
  /// Cheap, and rather once too often than not; BoomBeyond::isPart decides.
  bool mayBeStraight() const;

 private:
  double m_count = 0.0;
  Eigen::Vector3d m_sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d m_squares = Eigen::Matrix3d::Zero();
};

}  // namespace boomwatch
