#include "simulation/solids.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace boomwatch {
namespace {

using Eigen::Vector3d;

std::optional<Hit> castSide(const Cylinder& cylinder, const Vector3d& from, const Vector3d& ray) {
  const Vector3d& axis = cylinder.axis;
  const Vector3d a = from - axis * axis.dot(from);
  const Vector3d b = ray - axis * axis.dot(ray);
  // |a + t b| = radius
  const double squared = b.squaredNorm();
  const double root =
      a.dot(b) * a.dot(b) - squared * (a.squaredNorm() - cylinder.radius * cylinder.radius);
  if (squared <= 0.0 || root < 0.0) return std::nullopt;
  const double t = (-a.dot(b) - std::sqrt(root)) / squared;
  if (t <= 0.0 || std::abs(axis.dot(from + t * ray)) > cylinder.length / 2) return std::nullopt;
  return Hit{t, (a + t * b) / cylinder.radius};
}

std::optional<Hit> castEnd(const Cylinder& cylinder, const Vector3d& from, const Vector3d& ray) {
  const double slope = cylinder.axis.dot(ray);
  if (slope == 0.0) return std::nullopt;
  const Vector3d normal = slope < 0.0 ? cylinder.axis : Vector3d(-cylinder.axis);
  const double t = (cylinder.length / 2 - normal.dot(from)) / normal.dot(ray);
  if (t <= 0.0) return std::nullopt;
  const Vector3d p = from + t * ray;
  if ((p - normal * normal.dot(p)).squaredNorm() > cylinder.radius * cylinder.radius) {
    return std::nullopt;
  }
  return Hit{t, normal};
}

}  // namespace

Support supportOf(const Cylinder& cylinder) {
  return [cylinder](const Vector3d& direction) -> Vector3d {
    const double along = cylinder.axis.dot(direction);
    const Vector3d across = direction - along * cylinder.axis;
    const double length = across.norm();
    const Vector3d end =
        cylinder.centre + std::copysign(cylinder.length / 2, along) * cylinder.axis;
    return length > 0.0 ? Vector3d(end + across * (cylinder.radius / length)) : end;
  };
}

double Cylinder::distanceTo(const Vector3d& p) const {
  const double along = axis.dot(p - centre);
  const double across = (p - centre - along * axis).norm();
  return std::hypot(std::max(0.0, std::abs(along) - length / 2), std::max(0.0, across - radius));
}

std::optional<Hit> cast(const Ground& ground, const Vector3d& origin, const Vector3d& direction) {
  const double descent = -ground.up.dot(direction);
  const double height = ground.heightOf(origin);
  if (descent <= 0.0 || height <= 0.0) return std::nullopt;
  return Hit{height / descent, ground.up};
}

std::optional<Hit> cast(const Cylinder& cylinder, const Vector3d& origin,
                        const Vector3d& direction) {
  const Vector3d from = origin - cylinder.centre;
  if (cylinder.distanceTo(origin) <= 0.0) return std::nullopt;
  auto side = castSide(cylinder, from, direction);
  auto end = castEnd(cylinder, from, direction);
  if (!side || (end && end->depth < side->depth)) return end;
  return side;
}

std::optional<Hit> cast(const OrientedBox& box, const Vector3d& origin, const Vector3d& direction) {
  const Vector3d from = box.rotation.transpose() * (origin - box.centre);
  const Vector3d ray = box.rotation.transpose() * direction;
  double enter = 0.0, leave = std::numeric_limits<double>::infinity();
  int entered = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = box.size[axis] / 2;
    if (ray[axis] == 0.0) {
      if (std::abs(from[axis]) > half) return std::nullopt;
      continue;
    }
    const double sign = std::copysign(1.0, ray[axis]);
    const double near = (-sign * half - from[axis]) / ray[axis];
    if (near > enter) {
      enter = near;
      entered = axis;
    }
    leave = std::min(leave, (sign * half - from[axis]) / ray[axis]);
  }
  if (entered < 0 || enter > leave) return std::nullopt;
  return Hit{enter, box.rotation.col(entered) * -std::copysign(1.0, ray[entered])};
}

double distance(const OrientedBox& load, const Ground& ground) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vector3d& corner : load.corners()) {
    lowest = std::min(lowest, ground.heightOf(corner));
  }
  return std::max(0.0, lowest);
}

double distance(const OrientedBox& load, const Cylinder& cylinder) {
  return convexDistance(supportOf(load), supportOf(cylinder));
}

double distance(const OrientedBox& load, const OrientedBox& box) {
  return convexDistance(supportOf(load), supportOf(box));
}

}  // namespace boomwatch
