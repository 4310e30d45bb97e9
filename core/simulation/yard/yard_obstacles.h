#pragma once

#include "simulation/yard/yard_layout.h"

namespace boomwatch {

/// How near a load is to one thing. Metres.
struct YardApproach {
  YardKind kind = YardKind::Nothing;
  ConvexPair pair;  ///< `onA` on the load, `onB` on the thing
};

/// Everything in the yard that a load can run into and that has its place. Yard frame.
class YardObstacles {
 public:
  explicit YardObstacles(const YardLayout& layout) : m_layout(&layout) {}

  /// The nearest of all, within a micrometre. 0 when they touch or overlap, or the load is under
  /// the ground.
  YardApproach nearest(const OrientedBox& load) const;
  /// The ground, and then every one of YardLayout::fixed, in its order.
  std::vector<YardApproach> all(const OrientedBox& load) const;

 private:
  /// The ground, unless it is farther away than `limit`: then just some distance above `limit`.
  YardApproach ground(const OrientedBox& load, double limit) const;

  const YardLayout* m_layout;
};

/// The nearest of some bodies (one frame for all); absent when there are none.
std::optional<YardApproach> nearestOf(const OrientedBox& load, const Parts& parts);

}  // namespace boomwatch
