#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "environment/grid_geometry.h"
#include "frame/cloud.h"

namespace boomwatch {

/// Reduces a frame to one point for each cell of the model, at the depth of the surface in the
/// cell.
///
/// A slanted surface is nearer at one edge of a cell than in its middle. Its nearest point (Eq. 10)
/// puts it up to half a cell too near. This class takes the mean of all points within two cell
/// sizes behind the nearest point instead. The result lies at most one cell size behind the nearest
/// point, so a second surface close behind the first does not hide it.
///
/// Keeps its memory, 4 bytes a cell, between frames. Not thread-safe.
class CellSurfaces {
 public:
  /// `points`: finite, inside the bounds; camera frame, metres. Returns one point a cell, in order
  /// of first appearance. Points outside the grid are ignored.
  Points extract(std::span<const Eigen::Vector3f> points, const GridGeometry& geometry);

 private:
  /// The points of one cell; metres.
  struct Seen {
    std::size_t cell;
    Eigen::Vector3f first;  ///< the first of them
    float nearest;          ///< depth of the nearest
    float behind = 0.0F;    ///< sum of the depths of the surface points behind it
    int count = 1;          ///< of the surface points, the nearest included
  };
  void note(const Eigen::Vector3f& point, const GridGeometry& geometry);

  std::vector<std::uint32_t>
      m_seenOfCell;  ///< index into m_seen for each cell; none between frames
  std::vector<std::uint32_t> m_seenOfPoint;  ///< the same for each point
  std::vector<Seen> m_seen;
};

}  // namespace boomwatch
