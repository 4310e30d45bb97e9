#pragma once

#include <Eigen/Core>
#include <optional>

#include "frame/oriented_box.h"
#include "simulation/convex_pair.h"

namespace boomwatch {

/// Where a ray meets a surface: origin + depth * direction. The normal points out, length 1.
struct Hit {
  double depth = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

/// The ground: everything on the far side of a plane. Camera frame, metres.
struct Ground {
  Eigen::Vector3d up = -Eigen::Vector3d::UnitY();  ///< length 1
  double depth = 1.0;                              ///< of the ground below the camera, along `up`

  /// Above the ground positive, below negative.
  double heightOf(const Eigen::Vector3d& p) const { return up.dot(p) + depth; }
};

/// A solid cylinder with flat ends. Camera frame, metres.
struct Cylinder {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();  ///< length 1
  double length = 1.0;
  double radius = 0.5;

  /// How far `p` is from the solid; 0 inside.
  double distanceTo(const Eigen::Vector3d& p) const;
};

/// The first place at which a ray enters; absent where it misses or begins inside. The direction
/// need not have length 1.
std::optional<Hit> cast(const Ground& ground, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction);
std::optional<Hit> cast(const Cylinder& cylinder, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction);
std::optional<Hit> cast(const OrientedBox& box, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction);

/// The point of its rim that lies farthest along a direction.
Support supportOf(const Cylinder& cylinder);

/// How far a box is from a solid, 0 when they touch or overlap. Exact for the ground, within a
/// micrometre for the others. Metres.
double distance(const OrientedBox& load, const Ground& ground);
double distance(const OrientedBox& load, const Cylinder& cylinder);
double distance(const OrientedBox& load, const OrientedBox& box);

}  // namespace boomwatch
