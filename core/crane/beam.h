#pragma once

#include <Eigen/Core>
#include <optional>

#include "frame/cloud.h"

namespace boomwatch {

/// A straight section of a boom. Camera frame, metres.
struct Beam {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< unit
  double length = 0.0;
  double share = 0.0;  ///< of all points, those that belong to the beam; 0..1

  /// How far `p`, a point of the axis, lies beyond the nearer end; negative inside the beam.
  double beyondEnd(const Eigen::Vector3d& p) const { return (p - centre).norm() - length / 2; }
};

/// The line with the most points within `radius`, metres: RANSAC (Fischler and Bolles 1981), then
/// the principal axis of these points. Absent when the points are too few, or hardly longer than
/// wide. The same points always give the same beam. Pure.
std::optional<Beam> beamIn(const Points& points, double radius);

}  // namespace boomwatch
