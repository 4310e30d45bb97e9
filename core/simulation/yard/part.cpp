#include "simulation/yard/part.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <utility>

namespace boomwatch {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::string_view toString(YardKind kind) {
  constexpr std::array<std::string_view, 12> names{"nothing", "ground", "tree",   "stack",
                                                   "wall",    "person", "branch", "crane",
                                                   "tool",    "load",   "bird",   "leaf"};
  return names[static_cast<std::size_t>(kind)];
}

Matrix3d rotationWithY(const Vector3d& y, const Vector3d& near) {
  Matrix3d rotation;
  rotation.col(1) = y.normalized();
  Vector3d x = rotation.col(1).cross(near);
  if (x.norm() < 1e-6 * near.norm()) x = rotation.col(1).unitOrthogonal();
  rotation.col(0) = x.normalized();
  rotation.col(2) = rotation.col(0).cross(rotation.col(1));
  return rotation;
}

Part rod(const Vector3d& a, const Vector3d& b, double radius) {
  Part part;
  part.shape = Part::Shape::Cylinder;
  part.box = {(a + b) / 2, {2 * radius, (b - a).norm(), 2 * radius}, rotationWithY(b - a)};
  return part;
}

Part beam(const Vector3d& a, const Vector3d& b, double width, double depth, const Vector3d& near) {
  Part part;
  part.box = {(a + b) / 2, {width, (b - a).norm(), depth}, rotationWithY(b - a, near)};
  return part;
}

Part ellipsoid(const Vector3d& centre, const Vector3d& size, const Matrix3d& rotation) {
  Part part;
  part.shape = Part::Shape::Ellipsoid;
  part.box = {centre, size, rotation};
  return part;
}

Part withLook(Part part, YardKind kind, Material material, int variety) {
  part.kind = kind;
  part.material = material;
  part.variety = static_cast<std::uint8_t>(variety);
  return part;
}

Part turned(Part part, const Matrix3d& rotation) {
  part.box.centre = rotation * part.box.centre;
  part.box.rotation = rotation * part.box.rotation;
  return part;
}

Cylinder cylinderOf(const Part& part) {
  return {part.box.centre, part.box.rotation.col(1), part.box.size.y(), part.box.size.x() / 2};
}

namespace {

std::optional<Hit> castEllipsoid(const OrientedBox& box, const Vector3d& origin,
                                 const Vector3d& direction) {
  // In a space in which it is the unit ball.
  const Vector3d scale = 2.0 * box.size.cwiseInverse();
  const Vector3d from = scale.cwiseProduct(box.rotation.transpose() * (origin - box.centre));
  const Vector3d ray = scale.cwiseProduct(box.rotation.transpose() * direction);
  const double squared = ray.squaredNorm(), along = from.dot(ray);
  const double root = along * along - squared * (from.squaredNorm() - 1.0);
  if (root < 0.0) return std::nullopt;
  const double t = (-along - std::sqrt(root)) / squared;
  if (t <= 0.0) return std::nullopt;
  return Hit{t, (box.rotation * scale.cwiseProduct(from + t * ray)).normalized()};
}

}  // namespace

std::optional<Hit> cast(const Part& part, const Vector3d& origin, const Vector3d& direction) {
  switch (part.shape) {
    case Part::Shape::Cylinder:
      return cast(cylinderOf(part), origin, direction);
    case Part::Shape::Ellipsoid:
      return castEllipsoid(part.box, origin, direction);
    case Part::Shape::Box:
      break;
  }
  return cast(part.box, origin, direction);
}

Support supportOf(const Part& part) {
  if (part.shape == Part::Shape::Box) return supportOf(part.box);
  if (part.shape == Part::Shape::Cylinder) return supportOf(cylinderOf(part));
  return [box = part.box](const Vector3d& direction) -> Vector3d {
    const Vector3d half = box.size / 2;
    const Vector3d local = half.cwiseProduct(box.rotation.transpose() * direction);
    const double length = local.norm();
    if (length == 0.0) return box.centre;
    return box.centre + box.rotation * half.cwiseProduct(local / length);
  };
}

}  // namespace boomwatch
