#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "environment/grid_geometry.h"
#include "frame/cloud.h"

namespace boomwatch {

/// What a frame shows of the cells of a model: a point each, at the depth of the surface there.
///
/// A surface that is seen at an angle is nearer at one edge of a cell than in its middle, where the
/// model has it. By its nearest point alone (Eq. 10) it stands up to half a cell before where it
/// is. The mean of what lies within two cells of depth behind the nearest point does not. It is at
/// most one cell behind the nearest point, whatever the cell holds: what stands right before
/// something else is not lost.
///
/// Keeps its memory, 4 bytes a cell, between the frames. Not thread-safe.
class CellSurfaces {
 public:
  /// `points`: finite, inside the bounds; camera frame. In order of first appearance; a point
  /// outside the grid is left out.
  Points of(std::span<const Eigen::Vector3f> points, const GridGeometry& geometry);

 private:
  /// What is seen of a cell; metres.
  struct Seen {
    std::size_t cell;
    Eigen::Vector3f first;  ///< of its points
    float nearest;          ///< depth
    float behind = 0.0F;    ///< sum of what the points of the surface lie behind that
    int count = 1;          ///< of these points, with the nearest
  };
  void note(const Eigen::Vector3f& point, const GridGeometry& geometry);

  std::vector<std::uint32_t> m_seenOfCell;   ///< index of each cell; none between the frames
  std::vector<std::uint32_t> m_seenOfPoint;  ///< the same of each point
  std::vector<Seen> m_seen;
};

}  // namespace boomwatch
