#include "simulation/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

// Fig. 22. What follows from these is worked out below, so that the distances hold exactly.
constexpr double columnRadius = 0.15;
constexpr double columnLength = 3.0;
constexpr double frontColumnsZ = 5.0;
constexpr double pastZ = 8.0;
constexpr double loadY = -0.5;
constexpr double loadThickness = 0.3;
constexpr double inFrontDistance = 0.6;
constexpr double pastHeight = 1.9;

// Fig. 21 right.
constexpr double gableZ = 5.0;
constexpr double insideDistance = 0.7;

/// A ground whose far end rises by `slant` radians towards the optical axis.
Ground slantedGround(double slant, double depth) {
  return {{0.0, -std::cos(slant), -std::sin(slant)}, depth};
}

double groundY(const Ground& ground, double z) {
  return (ground.depth + ground.up.z() * z) / -ground.up.y();
}

Ground columnsGround() {
  Ground ground = slantedGround(10.0 * std::numbers::pi / 180.0, 0.0);
  // The lowest edge of the load, past the columns, is the one at its far side.
  const Vector3d edge(0.0, loadY + loadThickness / 2, pastZ + loadThickness / 2);
  ground.depth = pastHeight - ground.heightOf(edge);
  return ground;
}

}  // namespace

std::optional<Hit> cast(const Scene& scene, const Vector3d& origin, const Vector3d& direction) {
  std::optional<Hit> nearest = cast(scene.ground, origin, direction);
  const auto look = [&](const auto& solid) {
    const auto hit = cast(solid, origin, direction);
    if (hit && (!nearest || hit->depth < nearest->depth)) nearest = hit;
  };
  std::ranges::for_each(scene.cylinders, look);
  std::ranges::for_each(scene.boxes, look);
  return nearest;
}

double distance(const OrientedBox& load, const Scene& scene) {
  double nearest = distance(load, scene.ground);
  const auto look = [&](const auto& solid) { nearest = std::min(nearest, distance(load, solid)); };
  std::ranges::for_each(scene.cylinders, look);
  std::ranges::for_each(scene.boxes, look);
  return nearest;
}

std::optional<double> distanceToSeen(const OrientedBox& load, const Cloud& cloud) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3f& point : cloud.points) {
    if (!isMeasured(point)) continue;
    const Vector3d p = point.cast<double>();
    nearest = std::min(nearest, (load.nearestTo(p) - p).squaredNorm());
  }
  if (!std::isfinite(nearest)) return std::nullopt;
  return std::sqrt(nearest);
}

Scene floorScene() { return {slantedGround(20.0 * std::numbers::pi / 180.0, 3.6), {}, {}}; }

Scene cylindersScene() {
  Scene scene{columnsGround(), {}, {}};
  // The outer two stand clear of the line along which the load moves.
  const Eigen::Vector2d feet[] = {
      {-0.7, frontColumnsZ}, {0.7, frontColumnsZ}, {-2.2, 5.4}, {2.0, 5.6}};
  for (const Eigen::Vector2d& foot : feet) {
    const double y = groundY(scene.ground, foot.y()) - columnLength / 2;
    scene.cylinders.push_back(
        {{foot.x(), y, foot.y()}, Vector3d::UnitY(), columnLength, columnRadius});
  }
  return scene;
}

Scene wallScene() {
  // The camera looks straight at the gable from within the wall's thickness and below its top.
  const Vector3d size(0.2, 4.0, 4.0);
  const double top = -1.0;
  return {columnsGround(),
          {},
          {{{0.0, top + size.y() / 2, gableZ + size.z() / 2}, size, Eigen::Matrix3d::Identity()}}};
}

OrientedBox lyingLoad(const Vector3d& centre) {
  return {centre, {2.0, loadThickness, loadThickness}, Eigen::Matrix3d::Identity()};
}

OrientedBox cylindersInFront() {
  const double z = frontColumnsZ - columnRadius - inFrontDistance - loadThickness / 2;
  return lyingLoad({0.0, loadY, z});
}

OrientedBox cylindersInside() { return lyingLoad({0.0, loadY, frontColumnsZ}); }

OrientedBox cylindersPast() { return lyingLoad({0.0, loadY, pastZ}); }

OrientedBox wallInside() {
  return lyingLoad({0.0, 0.0, gableZ + insideDistance + loadThickness / 2});
}

}  // namespace boomwatch
