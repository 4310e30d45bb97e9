#pragma once

#include <cstdint>
#include <vector>

#include "environment/environment_model.h"
#include "frame/oriented_box.h"

namespace boomwatch {

/// How much of the space around a box was ever observed.
///
/// rebuild() after an update of the model (cheap when nothing new was observed), then query().
class ObservedShare {
 public:
  void rebuild(const EnvironmentModel& model);

  /// Share, 0..1, of the cells within `reach` metres of the box's footprint (the convex hull of its
  /// projected corners) that were ever observed. What lies outside the bounds counts as unobserved.
  double query(const OrientedBox& box, double reach) const;

 private:
  GridGeometry m_geometry;
  std::vector<std::uint32_t> m_prefix;  ///< observed cells left of column i, a row of columns + 1
};

}  // namespace boomwatch
