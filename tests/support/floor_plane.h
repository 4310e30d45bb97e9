#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "frame/cloud.h"
#include "frame/oriented_box.h"

namespace boomwatch::test {

/// A nearly level floor seen from above: z = a x + b y + c.
struct Floor {
  Eigen::Vector3d abc = {0.0, 0.0, 2.75};

  double depthAt(double x, double y) const { return abc.dot(Eigen::Vector3d(x, y, 1.0)); }
};

/// The part of the cloud that is looked at, metres.
struct Area {
  double xMin, xMax, yMin, yMax;
};

/// Least squares, again and again over the points that lie near the plane of the time before.
inline Floor fitFloor(const Cloud& cloud, const Area& area) {
  Floor floor;
  for (double near : {0.2, 0.15, 0.1, 0.08, 0.06, 0.06, 0.06}) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& p : cloud.points) {
      // Written so that a NaN fails.
      if (!(p.x() > area.xMin && p.x() < area.xMax && p.y() > area.yMin && p.y() < area.yMax)) {
        continue;
      }
      const Eigen::Vector3d row(p.x(), p.y(), 1.0);
      if (!(std::abs(p.z() - floor.abc.dot(row)) < near)) continue;
      normal += row * row.transpose();
      right += row * static_cast<double>(p.z());
    }
    if (normal(2, 2) < 100.0) return floor;
    floor.abc = normal.ldlt().solve(right);
  }
  return floor;
}

/// From the nearest corner of a box above the floor.
inline double distanceToPlane(const OrientedBox& box, const Floor& floor) {
  const double length = Eigen::Vector3d(-floor.abc.x(), -floor.abc.y(), 1.0).norm();
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& corner : box.corners()) {
    nearest = std::min(nearest, (floor.depthAt(corner.x(), corner.y()) - corner.z()) / length);
  }
  return nearest;
}

}  // namespace boomwatch::test
