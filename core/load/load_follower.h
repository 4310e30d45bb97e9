#pragma once

#include <array>

#include "load/load_detection.h"
#include "load/log/learnt_length.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// Follows the load from frame to frame: smooths its pose, learns and holds its sizes, and bridges
/// frames that do not show it. Used by one thread.
class LoadFollower {
 public:
  struct Followed {
    std::optional<OrientedBox> box;  ///< absent when the load has not been seen for too long
    std::optional<double> age;       ///< seconds since it was last seen; with `box`
  };

  /// `stamp`: of the frame, seconds. A load that is not seen is taken to move on as it did for up
  /// to `maxAge` seconds; after that all is forgotten, its sizes as well: another one may be
  /// carried next. With `tool`, the tool point, it is the tool that a load goes with that is not
  /// seen. A pose that jumps away is believed when the next frames agree with it. A stamp
  /// that runs backwards forgets all.
  Followed follow(const LoadDetection& detection, double stamp, const LoadParameters& parameters,
                  double maxAge, const std::optional<Eigen::Vector3f>& tool = {});
  void reset();

  /// Where the load is by `stamp` if it moves on as it did. Absent when there is none to follow.
  std::optional<OrientedBox> expected(double stamp, double maxAge,
                                      const std::optional<Eigen::Vector3f>& tool = {}) const;

 private:
  bool jumps(const OrientedBox& seen, const OrientedBox& expected, double passed) const;
  void begin(const OrientedBox& seen, double stamp);
  void correct(const OrientedBox& seen, const OrientedBox& expected, double passed);
  void learn(const Eigen::Vector3d& size, double stamp, const LoadParameters& parameters);
  OrientedBox boxAt(double passed, const std::optional<Eigen::Vector3f>& tool) const;

  struct Pose {
    OrientedBox box;                                     ///< its size is m_size
    Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< metres a second
    Eigen::Vector3d spin = Eigen::Vector3d::Zero();      ///< axis times radians a second
    double stamp = 0.0;                                  ///< when it was last seen
    std::optional<Eigen::Vector3f> tool;                 ///< where the tool was then
  };
  std::optional<Pose> m_pose;
  int m_jumps = 0;  ///< frames in a row that show it elsewhere
  double m_learningSince = 0.0;
  std::array<LearntLength, 3> m_learnt;  ///< of the box's own axes
  Eigen::Vector3d m_size = Eigen::Vector3d::Zero();
};

/// `seen` with its axes named so that they fit `before`: a box is the same when it is turned by
/// half a turn, and by a quarter where its sizes are swapped with it.
OrientedBox namedAs(const OrientedBox& before, const OrientedBox& seen);

}  // namespace boomwatch
