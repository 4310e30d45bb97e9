#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <unordered_set>

#include "frame/cloud.h"

namespace boomwatch {

/// Where boom and tool were a moment ago. Noise, or an object that passes in front, can cut a part
/// off the tool's cluster for one frame. The memory keeps this part from becoming an obstacle.
/// Camera frame, metres, seconds on the source's clock. Several threads may call knows().
class CraneMemory {
 public:
  static constexpr double cell = 0.12;     ///< side of the remembered cubes
  static constexpr double lasting = 0.25;  ///< seconds for which a place is remembered

  /// Remembers the points of the crane. Without the Remembered clusters: otherwise an object that
  /// stands where the boom once was would never become an obstacle.
  void note(double stamp, const Points& crane);
  /// Drops moments that are too old for a frame of this stamp, and those after it (clock set back).
  void forgetBefore(double stamp);

  bool knows(const Eigen::Vector3f& p) const;

 private:
  struct Moment {
    double stamp;
    Eigen::AlignedBox3f box;
    std::unordered_set<std::int64_t> places;
  };
  std::deque<Moment> m_moments;
};

}  // namespace boomwatch
