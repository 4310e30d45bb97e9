#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "frame/cloud.h"
#include "frame/oriented_box.h"

/// Clouds of surfaces whose depth is known in closed form, as a pinhole camera sees them.
namespace boomwatch::ray_cast {

using Eigen::Vector3d;

/// Depth where a ray meets nothing: further than all else.
inline constexpr double nothing = std::numeric_limits<double>::infinity();

/// z at which the ray (u, v, 1) meets the plane normal . p = offset.
inline double planeDepth(const Vector3d& normal, double offset, double u, double v) {
  const double z = offset / normal.dot(Vector3d(u, v, 1.0));
  return z > 0.0 ? z : nothing;
}

/// A solid cylinder with flat ends, `length` long about `centre`; `axis` has length 1.
struct Rod {
  Vector3d centre, axis;
  double length, radius;

  double depth(double u, double v) const {
    const Vector3d ray(u, v, 1.0);
    const Vector3d across = ray - axis * axis.dot(ray);
    const Vector3d offset = -(centre - axis * axis.dot(centre));
    const double a = across.squaredNorm(), b = across.dot(offset);
    const double root = b * b - a * (offset.squaredNorm() - radius * radius);
    double nearest = nothing;
    if (root >= 0.0) {
      const double z = (-b - std::sqrt(root)) / a;
      if (std::abs(axis.dot(z * ray - centre)) <= length / 2.0) nearest = z;
    }
    for (const double end : {-length / 2.0, length / 2.0}) {
      const double z = (axis.dot(centre) + end) / axis.dot(ray);
      const Vector3d off = z * ray - (centre + end * axis);
      if (z > 0.0 && off.squaredNorm() <= radius * radius) nearest = std::min(nearest, z);
    }
    return nearest;
  }
};

/// z at which the ray (u, v, 1) meets a box.
inline double boxDepth(const OrientedBox& box, double u, double v) {
  const Vector3d from = -box.rotation.transpose() * box.centre;
  const Vector3d ray = box.rotation.transpose() * Vector3d(u, v, 1.0);
  double in = 0.0, out = nothing;
  for (int i = 0; i < 3; ++i) {
    const double a = (-box.size[i] / 2.0 - from[i]) / ray[i];
    const double b = (box.size[i] / 2.0 - from[i]) / ray[i];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in < out ? in : nothing;
}

/// What a camera of 641 x 481 pixels with f = 600 pixels sees of `depth(u, v)`, metres along z;
/// where that is `nothing`, no point was measured.
template <class Depth>
Cloud seen(Depth&& depth) {
  constexpr int width = 641, height = 481;
  constexpr double focal = 600.0;
  Cloud cloud;
  cloud.width = width;
  cloud.height = height;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const double u = (column - width / 2) / focal, v = (row - height / 2) / focal;
      const double z = depth(u, v);
      cloud.points.push_back(std::isfinite(z) ? (z * Vector3d(u, v, 1.0)).cast<float>().eval()
                                              : unmeasuredPoint());
    }
  }
  return cloud;
}

/// A log across the view, and where the camera sees its middle: there the tool is.
inline const Rod heldLog{{0.1, 0.05, 4.0}, Vector3d(0.9, 0.2, 0.3).normalized(), 2.4, 0.15};
inline Vector3d nearSide(const Rod& rod) {
  const Vector3d away = rod.centre - rod.axis * rod.axis.dot(rod.centre);
  return rod.centre - rod.radius * away.normalized();
}

/// A rod before a wall at 8 m.
inline Cloud beforeWall(const Rod& rod) {
  return seen([&](double u, double v) { return std::min(rod.depth(u, v), 8.0); });
}

/// Standard deviation of the inverse depth of points without noise, but for float's.
inline constexpr double noise = 1e-4;

}  // namespace boomwatch::ray_cast
