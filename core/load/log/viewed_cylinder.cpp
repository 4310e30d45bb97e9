#include "load/log/viewed_cylinder.h"

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

NearLine NearLine::fromAxis(const CylinderFrame& frame, const LoadAxis& axis) {
  constexpr double step = 0.1;
  const auto a = frame.look(Vector3d(axis.point - step * axis.direction));
  const auto b = frame.look(Vector3d(axis.point + step * axis.direction));
  return {a.u, b.u, a.v, b.v, a.q, b.q};
}

NearLine NearLine::fromCylinder(const ViewedCylinder& cylinder) {
  const CylinderOutline outline(cylinder);
  const double ua = cylinder.ua, ub = cylinder.ub;
  const double va = cylinder.axisV(ua), vb = cylinder.axisV(ub);
  return {ua, ub, va, vb, outline.q(ua, va), outline.q(ub, vb)};
}

std::vector<int> cellsBeside(const DepthPatch& patch, const CylinderFrame& frame,
                             const NearLine& line, double halfWidth) {
  std::vector<int> cells;
  const auto at = [&](int row, int column) {
    return frame.look(
        Vector3d(patch.u0 + (column + 0.5) * patch.cell, patch.v0 + (row + 0.5) * patch.cell, 1.0));
  };
  for (int cell = 0; cell < patch.side * patch.side; ++cell) {
    const auto k = static_cast<std::size_t>(cell);
    if (patch.begin[k] == patch.begin[k + 1]) continue;
    const CylinderFrame::Seen seen = at(cell / patch.side, cell % patch.side);
    if (std::abs(seen.v - line.v(seen.u)) < halfWidth * line.q(seen.u) + 2.0 * patch.cell) {
      cells.push_back(cell);
    }
  }
  return cells;
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
