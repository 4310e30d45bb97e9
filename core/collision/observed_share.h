#pragma once

#include <cstdint>
#include <vector>

#include "environment/environment_model.h"
#include "frame/oriented_box.h"

namespace boomwatch {

/// How much of the space around a box was ever observed. A cell was never observed where nothing
/// was ever seen in it, and where its surface lies nearer to the camera than all of the box: what
/// is beside the box there is hidden behind that surface (the 2.5-D limit; docs/method.md
/// section 6).
///
/// In perspective cells are rays, and the reach is that of the box's point nearest to the camera.
///
/// rebuild() after an update of the model, then query() as often as wanted; query() is const and
/// may run on several threads at once. Keeps a byte a cell: the model may go.
class ObservedShare {
 public:
  void rebuild(const EnvironmentModel& model);

  /// Share, 0..1, of the cells that were ever observed, among those whose centre lies within
  /// `reach` metres of the box's footprint (the convex hull of its projected corners); when there
  /// is no such centre, of the one cell below the box's centre. What lies outside the bounds counts
  /// as unobserved, cell by cell, as if the grid went on. 0 before the first rebuild(), when the
  /// box is not one (see isUsable) or `reach` is not a finite number; a negative reach counts as 0.
  /// Time is bounded by the size of the grid.
  double query(const OrientedBox& box, double reach) const;

 private:
  GridGeometry m_geometry;
  /// How deep a cell was seen, in depth levels: 0 not at all, 255 through to the end; row-major.
  std::vector<std::uint8_t> m_seenTo;
};

/// How much of the `reach` metres before and behind the box lies between zMin and zMax, 0..1, on
/// the side that is the worse: what is nearer or farther than the bounds is not watched, as little
/// as what lies beside them. Behind the camera there is nothing to watch. 0 when the box is not one
/// or `reach` is no finite number; a negative reach counts as 0.
double watchedDepth(const OrientedBox& box, double reach, const Bounds& bounds);

}  // namespace boomwatch
