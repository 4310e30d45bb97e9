#pragma once

#include <vector>

#include "frame/cloud.h"
#include "simulation/solids.h"

namespace boomwatch {

/// A simulated environment with closed-form geometry. Camera frame, metres.
struct Scene {
  Ground ground;
  std::vector<Cylinder> cylinders;
  std::vector<OrientedBox> boxes;
};

/// The first surface that a ray meets; absent where it meets none.
std::optional<Hit> cast(const Scene& scene, const Eigen::Vector3d& origin,
                        const Eigen::Vector3d& direction);

/// How far a box is from the nearest solid of the scene, seen or not; 0 when they touch or overlap.
/// Metres, within a micrometre.
double distance(const OrientedBox& load, const Scene& scene);

/// How far a box is from the nearest measured point of a cloud: from the surface that was *seen*,
/// as densely as the cloud samples it. Absent when no point was measured. 0: a point lies inside.
std::optional<double> distanceToSeen(const OrientedBox& load, const Cloud& cloud);

/// Fig. 11: a ground that slants towards the camera.
Scene floorScene();

/// Fig. 21 left and 22: four upright cylinders, 3 m high and 0.3 m thick, on such a ground.
Scene cylindersScene();

/// Fig. 21 right: a wall on the ground, parallel to the optical axis and around it, so that the
/// camera sees its gable only.
Scene wallScene();

/// Fig. 22's colliding object, a lying cylinder 2 m long and 0.3 m thick, as its box.
OrientedBox lyingLoad(const Eigen::Vector3d& centre);

/// The three poses of Fig. 22 in cylindersScene(), on one line along z: 0.6 m in front of all
/// cylinders; amid two of them (0 m); past all of them, 1.9 m above the ground.
OrientedBox cylindersInFront();
OrientedBox cylindersInside();
OrientedBox cylindersPast();

/// Fig. 21 right: in wallScene(), inside the wall, 0.7 m behind its gable. The true distance is 0;
/// a model that knows only the gable measures 0.7 m.
OrientedBox wallInside();

}  // namespace boomwatch
