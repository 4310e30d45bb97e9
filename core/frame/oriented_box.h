#pragma once

#include <Eigen/Core>
#include <array>

namespace boomwatch {

/// A box that may be turned: the load's bounding volume. Camera frame, metres, radians.
struct OrientedBox {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< full lengths along the box's own x, y, z
  /// Columns are the box's own axes in the camera frame.
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();

  /// Corner k has sign (k & 1, k & 2, k & 4) along the box's x, y, z.
  std::array<Eigen::Vector3d, 8> corners() const;
  /// The surface belongs to it.
  bool contains(const Eigen::Vector3d& p) const;
  /// The point of the solid box nearest to `p`; `p` itself when it lies inside.
  Eigen::Vector3d nearestTo(const Eigen::Vector3d& p) const;
};

/// Yaw about y, then pitch about x, then roll about z, each about the axes that the turn before
/// left behind (R = Ry Rx Rz). Radians.
Eigen::Matrix3d rotationFromYawPitchRoll(double yaw, double pitch, double roll);

/// A box along the camera's axes.
struct AxisAlignedBox {
  Eigen::Vector3d min = Eigen::Vector3d::Zero();
  Eigen::Vector3d max = Eigen::Vector3d::Zero();

  /// The surface belongs to it.
  bool contains(const Eigen::Vector3d& p) const {
    return (p.array() >= min.array()).all() && (p.array() <= max.array()).all();
  }
};

}  // namespace boomwatch
