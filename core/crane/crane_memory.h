#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <unordered_set>

#include "frame/cloud.h"

namespace boomwatch {

/// Where boom and tool were a moment ago. What is cut off from the tool's cluster in one frame, by
/// noise or by what passes before it, is not an obstacle that has come out of nothing. Camera
/// frame, metres, seconds on the source's clock. knows() may be called by several threads.
class CraneMemory {
 public:
  static constexpr double cell = 0.12;     ///< side of the cubes in which places are remembered
  static constexpr double lasting = 0.25;  ///< for how long

  /// What was found to be the crane by itself, not what only this memory took for crane: or
  /// what stands where the boom once was would never be an obstacle.
  void note(double stamp, const Points& crane);
  /// Drops what is too old for a frame of this stamp, and everything when the clock was set back.
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
