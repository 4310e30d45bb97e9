#include "frame/oriented_box.h"

#include <Eigen/Geometry>

namespace boomwatch {

std::array<Eigen::Vector3d, 8> OrientedBox::corners() const {
  std::array<Eigen::Vector3d, 8> result;
  for (unsigned k = 0; k < 8; ++k) {
    const Eigen::Vector3d sign(k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5);
    result[k] = centre + rotation * sign.cwiseProduct(size);
  }
  return result;
}

bool OrientedBox::contains(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d local = rotation.transpose() * (p - centre);
  return (local.array().abs() <= size.array() / 2).all();
}

Eigen::Vector3d OrientedBox::nearestTo(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d local = rotation.transpose() * (p - centre);
  const Eigen::Vector3d inside = local.cwiseMax(-size / 2).cwiseMin(size / 2);
  return inside == local ? p : Eigen::Vector3d(centre + rotation * inside);
}

Eigen::Matrix3d rotationFromYawPitchRoll(double yaw, double pitch, double roll) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return (AngleAxisd(yaw, Vector3d::UnitY()) * AngleAxisd(pitch, Vector3d::UnitX()) *
          AngleAxisd(roll, Vector3d::UnitZ()))
      .toRotationMatrix();
}

}  // namespace boomwatch
