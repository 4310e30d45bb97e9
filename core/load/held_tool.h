#pragma once

#include <Eigen/Core>
#include <optional>

#include "frame/oriented_box.h"

namespace boomwatch {

/// Where the tool is by the load that it holds: a tracker that slides off the tool, or loses it,
/// takes with it what tells the load from an obstacle, though the load itself is seen all the time.
///
/// The tool's place along the load's x, and beside it in the camera's frame, is learnt while both
/// are seen. It holds for maxHold seconds after the tool was: by then the load may have been
/// laid down. Camera frame, metres, seconds. Used by one thread.
class HeldTool {
 public:
  static constexpr double maxHold = 4.0;

  /// Both were seen in the frame of `stamp`. A stamp that runs backwards forgets what was learnt.
  void learn(const Eigen::Vector3f& tool, const OrientedBox& load, double stamp);
  /// By a load that is seen. Absent when nothing is known, or not any more.
  std::optional<Eigen::Vector3f> point(const OrientedBox& load, double stamp) const;
  void reset() { *this = HeldTool(); }

 private:
  struct Grip {
    double along;  ///< the load's x, from its centre
    Eigen::Vector3d beside;
    double stamp;
  };
  std::optional<Grip> m_grip;
};

}  // namespace boomwatch
