#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "frame/oriented_box.h"

namespace boomwatch {

/// A box's outline in the x-y plane, the convex hull of its projected corners, grown by `reach`
/// metres on all sides (the Minkowski sum with a disc). Pure; camera frame, metres.
class Footprint {
 public:
  struct Interval {
    double low, high;
  };

  /// `reach` must not be negative.
  Footprint(const OrientedBox& box, double reach);
  /// Of any points of a plane, at least one.
  Footprint(std::vector<Eigen::Vector2d> points, double reach);

  /// The y between which it lies.
  Interval rows() const;
  /// Its x at this y; absent when it does not reach there.
  std::optional<Interval> at(double y) const;

 private:
  std::vector<Eigen::Vector2d> m_hull;  // in turn around it; two points or one if it is flat
  double m_reach;
};

}  // namespace boomwatch
