#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>

#include "collision/exact_clearance.h"
#include "frame/oriented_box.h"

namespace boomwatch {

/// How the load moves towards what is around it.
struct Approach {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< of the load's centre, m/s, camera frame
  /// How fast it comes nearer to the nearest point, m/s; negative: it retreats. Absent without one.
  std::optional<double> closingSpeed;
  /// Seconds until the load, carried on as it moves now, touches something; absent: not within the
  /// horizon asked for.
  std::optional<double> timeToContact;
};

/// The load's velocity from where it was: the slope of a straight line through the centres of the
/// last half second, by least squares. Turning about its own centre is not seen. Used by one
/// thread.
class LoadMotion {
 public:
  static constexpr double window = 0.5;  ///< seconds that are looked back on
  /// Shorter than this, noise would be taken for speed. Seconds.
  static constexpr double shortest = 0.15;

  /// `stamp` in seconds on the source's clock, `centre` in metres. Absent while too little was
  /// seen: at the beginning, after a gap longer than the window, after the clock was set back.
  std::optional<Eigen::Vector3d> update(double stamp, const Eigen::Vector3d& centre);
  void reset() { m_track.clear(); }

 private:
  struct Place {
    double stamp;
    Eigen::Vector3d centre;
  };
  std::deque<Place> m_track;
};

/// Seconds until `load`, moved on without turning at `velocity` (m/s), comes so near to an occupied
/// cell that the size of a cell cannot tell it from touching; 0 when it is that near already,
/// absent when it is not within `horizon` seconds or does not move.
///
/// Conservative advancement (Mirtich, "Impulse-based Dynamic Simulation", 1996): it can be carried
/// as far as it is away from the nearest thing without a query in between, so nothing is missed.
std::optional<double> timeToContact(const ExactClearance& exact, const OrientedBox& load,
                                    const Eigen::Vector3d& velocity, double horizon);

}  // namespace boomwatch
