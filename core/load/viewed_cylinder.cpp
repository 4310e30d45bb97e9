#include "load/viewed_cylinder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace boomwatch {

using Eigen::Vector3d;

std::optional<CylinderFrame> CylinderFrame::facing(const Vector3d& point, const Vector3d& direction,
                                                   double endOn) {
  CylinderFrame frame;
  frame.view = point.normalized();
  const Vector3d along = direction - frame.view * frame.view.dot(direction);
  if (!(along.norm() > std::sin(endOn))) return std::nullopt;
  frame.along = along.normalized();
  frame.across = frame.view.cross(frame.along);
  return frame;
}

CylinderOutline::CylinderOutline(const ViewedCylinder& cylinder)
    : m_point(cylinder.pointA()), m_axis(cylinder.direction()), m_radius(cylinder.radius()) {
  const Vector3d away = m_point - m_axis * m_axis.dot(m_point);
  const double distance = away.norm();
  const Vector3d back = away / distance, side = m_axis.cross(back);
  const double sine = std::min(1.0, m_radius / distance);
  const double cosine = std::sqrt(1.0 - sine * sine);
  // n . axis point = +-radius for a plane through the origin with normal n.
  const Vector3d one = cosine * side + sine * back, other = cosine * side - sine * back;
  m_upper = one, m_lower = other;
  const double u = cylinder.ua;
  if (edge(u, true) < edge(u, false)) std::swap(m_upper, m_lower);
}

double CylinderOutline::q(double u, double v) const {
  const Vector3d ray(1.0, u, v);
  const Vector3d b = ray - m_axis * m_axis.dot(ray);
  const Vector3d a = m_point - m_axis * m_axis.dot(m_point);
  const double squared = b.squaredNorm(), middle = a.dot(b);
  const double root = middle * middle - squared * (a.squaredNorm() - m_radius * m_radius);
  const double depth = (middle - std::sqrt(std::max(0.0, root))) / squared;
  return 1.0 / std::max(depth, 1e-3);
}

double CylinderOutline::edge(double u, bool upper) const {
  const Vector3d& n = upper ? m_upper : m_lower;
  return -(n[0] + u * n[1]) / n[2];
}

}  // namespace boomwatch
