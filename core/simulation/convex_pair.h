#pragma once

#include <Eigen/Core>
#include <functional>

#include "frame/oriented_box.h"

namespace boomwatch {

/// The point of a convex body that lies farthest along a direction (which need not have length 1,
/// and is never zero).
using Support = std::function<Eigen::Vector3d(const Eigen::Vector3d& direction)>;

/// Where two convex bodies are nearest to each other. Metres.
struct ConvexPair {
  double distance = 0.0;  ///< 0 when they touch or overlap; the points then mean nothing
  Eigen::Vector3d onA = Eigen::Vector3d::Zero();
  Eigen::Vector3d onB = Eigen::Vector3d::Zero();
};

/// How far two convex bodies are apart, and between which points.
///
/// The point of their Minkowski difference nearest to the origin, by Wolfe's algorithm ("Finding
/// the nearest point in a polytope", 1976), until the lower bound that the support planes give is
/// within a micrometre. Pure.
ConvexPair nearestPair(const Support& a, const Support& b);
double convexDistance(const Support& a, const Support& b);

/// The farthest corner of a box.
Support supportOf(const OrientedBox& box);

}  // namespace boomwatch
