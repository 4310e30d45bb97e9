#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <optional>

#include "load/log/axis_search.h"

namespace boomwatch {

/// Axes that look along a cylinder's middle: `view` towards it, `along` in the direction in which
/// the camera sees its axis run, `across` at right angles to both. Directions are (along/view,
/// across/view), depths 1/view: the patch's u, v, q turned.
struct CylinderFrame {
  Eigen::Vector3d view, along, across;

  /// Absent when the axis points at the camera, within about `endOn` radians.
  static std::optional<CylinderFrame> facing(const Eigen::Vector3d& point,
                                             const Eigen::Vector3d& direction, double endOn);
  struct Seen {
    double u, v, q;
  };
  Seen look(const Eigen::Vector3d& p) const {
    const double depth = p.dot(view);
    return {p.dot(along) / depth, p.dot(across) / depth, 1.0 / depth};
  }
  Seen look(const DepthPatch::Sample& s) const {
    const Seen seen = look(Eigen::Vector3d(s.u, s.v, 1.0));
    return {seen.u, seen.v, seen.q * s.q};
  }
  /// From this frame's (view, along, across) to the camera's.
  Eigen::Vector3d toCamera(const Eigen::Vector3d& local) const {
    return view * local[0] + along * local[1] + across * local[2];
  }
  Eigen::Vector3d toLocal(const Eigen::Vector3d& p) const {
    return {p.dot(view), p.dot(along), p.dot(across)};
  }
};

/// An endless cylinder in such a frame, by two points of its axis (v and q at two fixed u) and its
/// radius: five numbers, of which v and radius are seen in the outline and q in the depth.
struct ViewedCylinder {
  static constexpr int parameters = 5;
  double ua = -0.1, ub = 0.1;
  Eigen::Matrix<double, parameters, 1> x;  ///< va, vb, qa, qb, radius

  double radius() const { return x[4]; }
  /// Of the axis; (view, along, across), metres.
  Eigen::Vector3d pointA() const { return Eigen::Vector3d(1.0, ua, x[0]) / x[2]; }
  Eigen::Vector3d pointB() const { return Eigen::Vector3d(1.0, ub, x[1]) / x[3]; }
  Eigen::Vector3d direction() const { return (pointB() - pointA()).normalized(); }
  /// Where the axis is seen at `u`.
  double axisV(double u) const { return x[0] + (x[1] - x[0]) * (u - ua) / (ub - ua); }
  double axisQ(double u) const { return x[2] + (x[3] - x[2]) * (u - ua) / (ub - ua); }
  bool isUsable() const { return x.allFinite() && x[2] > 0.0 && x[3] > 0.0 && x[4] > 0.0; }
};

/// A straight line in such a frame: straight there too, v as well as q.
struct NearLine {
  double ua = -0.1, ub = 0.1, va = 0.0, vb = 0.0, qa = 1.0, qb = 1.0;

  double v(double u) const { return va + (vb - va) * (u - ua) / (ub - ua); }
  double q(double u) const { return qa + (qb - qa) * (u - ua) / (ub - ua); }
  /// (view, along, across), metres; q there must be positive.
  Eigen::Vector3d at(double u) const { return Eigen::Vector3d(1.0, u, v(u)) / q(u); }
  /// Towards larger u.
  Eigen::Vector3d direction() const { return (at(ub) - at(ua)).normalized(); }
  static NearLine fromAxis(const CylinderFrame& frame, const LoadAxis& axis);
  /// Where a cylinder is nearest to the camera.
  static NearLine fromCylinder(const ViewedCylinder& cylinder);
};

/// Along a line, from where it passes the tool. Metres.
struct AlongRange {
  double toolRadius;  ///< so far to both sides is the tool: left out
  double from = -std::numeric_limits<double>::infinity();  ///< and what lies before or beyond
  double to = std::numeric_limits<double>::infinity();

  bool holds(double along) const {
    return std::abs(along) > toolRadius && along > from && along < to;
  }
};

/// The measured cells that may lie within `halfWidth` metres of the line as it is seen, whatever
/// their depth.
std::vector<int> cellsBeside(const DepthPatch& patch, const CylinderFrame& frame,
                             const NearLine& line, double halfWidth);

/// What a ViewedCylinder looks like, for many directions at a time.
class CylinderOutline {
 public:
  explicit CylinderOutline(const ViewedCylinder& cylinder);

  /// Inverse depth of the near surface; of the nearest approach where the ray misses.
  double q(double u, double v) const;
  /// Where the outline is at `u`: the upper (larger v) or the lower edge. The outline is where a
  /// plane through the camera touches.
  double edge(double u, bool upper) const;

 private:
  Eigen::Vector3d m_point, m_axis;
  double m_radius;
  Eigen::Vector3d m_upper, m_lower;  ///< normals of the touching planes
};

}  // namespace boomwatch
