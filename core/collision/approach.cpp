#include "collision/approach.h"

#include <algorithm>

namespace boomwatch {

using Eigen::Vector3d;

std::optional<Vector3d> LoadMotion::update(double stamp, const Vector3d& centre) {
  if (!m_track.empty() &&
      (stamp <= m_track.back().stamp || stamp - m_track.back().stamp > window)) {
    m_track.clear();
  }
  m_track.push_back({stamp, centre});
  while (stamp - m_track.front().stamp > window) m_track.pop_front();
  if (m_track.size() < 3 || stamp - m_track.front().stamp < shortest) return std::nullopt;

  double meanStamp = 0.0;
  Vector3d meanCentre = Vector3d::Zero();
  for (const Place& place : m_track) {
    meanStamp += place.stamp / static_cast<double>(m_track.size());
    meanCentre += place.centre / static_cast<double>(m_track.size());
  }
  double spread = 0.0;
  Vector3d slope = Vector3d::Zero();
  for (const Place& place : m_track) {
    const double offset = place.stamp - meanStamp;
    spread += offset * offset;
    slope += offset * (place.centre - meanCentre);
  }
  return slope / spread;
}

std::optional<double> timeToContact(const ExactClearance& exact, const OrientedBox& load,
                                    const Vector3d& velocity, double horizon) {
  // Along a surface that it nearly touches, the load would advance by next to nothing a step. Going
  // this far instead, it may enter by as much, but not pass through: that is seen a step later.
  const double minStep = std::clamp(load.size.minCoeff() / 2, 0.01, 0.05);
  constexpr int maxSteps = 500;
  const double speed = velocity.norm();
  if (!(speed > 0.0)) return std::nullopt;
  double time = 0.0;
  for (int step = 0; step < maxSteps && time <= horizon; ++step) {
    OrientedBox moved = load;
    moved.centre += time * velocity;
    const Clearance clearance = exact.query(moved, speed * (horizon - time) + 1.0);
    if (!clearance.nearest) return std::nullopt;
    const Nearest& nearest = *clearance.nearest;
    if (nearest.distance <= nearest.quantisation) return time;
    time += std::max(nearest.distance, minStep) / speed;
  }
  // Never so many steps but close to a surface: as good as a contact.
  return time <= horizon ? std::optional(time) : std::nullopt;
}

}  // namespace boomwatch
