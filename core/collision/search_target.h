#pragma once

#include <Eigen/Core>

#include "frame/oriented_box.h"

namespace boomwatch {

/// An oriented box as a search for what is nearest to it needs it. Distances are squared, in square
/// metres; camera frame. Const members may be called by several threads at once.
class SearchTarget {
 public:
  explicit SearchTarget(const OrientedBox& box)
      : m_centre(box.centre),
        m_half(box.size / 2),
        m_outerHalf(box.rotation.cwiseAbs() * m_half),
        m_toBox(box.rotation.transpose()),
        m_toBoxExtent(m_toBox.cwiseAbs()) {}

  double distanceTo(const Eigen::Vector3d& p) const {
    return ((m_toBox * (p - m_centre)).cwiseAbs() - m_half).cwiseMax(0).squaredNorm();
  }

  /// Never more than the distance to any point of the block centre +- extent: the larger of two
  /// gaps, that along the model's axes (the box in its hull) and that along the box's (the block in
  /// its hull).
  double lowerBound(const Eigen::Vector3d& centre, const Eigen::Vector3d& extent) const {
    const Eigen::Vector3d offset = centre - m_centre;
    const Eigen::Vector3d alongModel = offset.cwiseAbs() - extent - m_outerHalf;
    const Eigen::Vector3d alongBox =
        (m_toBox * offset).cwiseAbs() - m_toBoxExtent * extent - m_half;
    return std::max(alongModel.cwiseMax(0).squaredNorm(), alongBox.cwiseMax(0).squaredNorm());
  }

  /// The point of the line from a to b that is nearest to the box: exact, the distance to a box
  /// being convex and piecewise quadratic along a line.
  Eigen::Vector3d nearestOnLine(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const;

 private:
  Eigen::Vector3d m_centre, m_half, m_outerHalf;
  Eigen::Matrix3d m_toBox, m_toBoxExtent;
};

}  // namespace boomwatch
