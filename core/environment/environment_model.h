#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "environment/cell_update.h"
#include "environment/depth_view.h"
#include "environment/grid_geometry.h"
#include "frame/cloud.h"
#include "parameters/parameters.h"

namespace boomwatch {

/// State of a cell. Unobserved and free are different.
enum class CellState { NeverObserved, ObservedFree, Occupied };

/// The 2.5-D probabilistic model of the static environment (docs/method.md section 6, Eq. 6, 8-11;
/// other update rules: see updateCells).
///
/// Row-major arrays of `geometry().columns() x rows()`. A cell has a float probability and an 8-bit
/// depth level, 5 bytes. A level above 0 means occupied. A probability of exactly 0 means
/// unobserved: the cell was never measured, or not for so long that Eq. 8 brought it below
/// `observedFloor` (with the defaults, 19 frames after 2/3). So a surface that later gives no
/// depth, because it is over-exposed or occluded, becomes unobserved and not free. Not thread-safe;
/// copies are independent.
class EnvironmentModel {
 public:
  EnvironmentModel() : EnvironmentModel(GridGeometry{}) {}
  explicit EnvironmentModel(const GridGeometry& geometry);

  /// Adds one frame: crops `points` to the bounds, projects them (the nearest point of a cell wins)
  /// and updates the cells. Points that are not finite or before zMin are ignored. A point beyond
  /// zMax, inside the bounds in x and y, shows that its cell is free in this frame. In perspective
  /// a point outside the bounds in x or y shows the same.
  ///
  /// `masked`: points of boom, tool and load. They occlude the cell in which they lie, if it has no
  /// other measurement. An occluded cell keeps its state, so that an obstacle stays in the model
  /// while the load enters it. There are three exceptions, in which Eq. 8 goes on:
  /// - the masked point lies behind the surface of the cell;
  /// - the camera sees through the surface (needs `view`);
  /// - the surface had missed so many frames before that it was about to leave.
  /// With a `view`, an old surface is also occluded by any object before it on its ray.
  void update(std::span<const Eigen::Vector3f> points, const ModelParameters& parameters,
              std::span<const Eigen::Vector3f> masked = {}, const DepthView* view = nullptr);

  const GridGeometry& geometry() const { return m_geometry; }
  std::span<const float> probabilities() const { return m_probabilities; }
  std::span<const std::uint8_t> levels() const { return m_levels; }
  std::size_t frames() const { return m_frames; }  ///< updates since construction

  CellState state(int column, int row) const { return state(m_geometry.index(column, row)); }
  CellState state(std::size_t k) const {
    if (m_levels[k] > 0) return CellState::Occupied;
    return m_probabilities[k] > 0.0F ? CellState::ObservedFree : CellState::NeverObserved;
  }

  /// Sets one cell, which must be inside the grid. For tests and for maps from files.
  void set(int column, int row, float probability, std::uint8_t level);

 private:
  /// A range of cells, by index.
  struct Cells {
    std::size_t begin, end;
    bool contain(std::size_t k) const { return k >= begin && k < end; }
  };
  /// One point in its cell: 256 - level, or 0 when the point shows that the cell is free.
  struct SeenCell {
    std::size_t index;
    std::uint8_t nearness;
  };
  struct OccludedCell {
    std::size_t index;
    float probability;
    std::uint8_t level;
  };
  // An update runs on two threads. Each projects half of the points into its own half of the rows,
  // and keeps points for the other half as strays. When both are done, each updates its rows. No
  // cell is shared, so the result does not depend on timing.
  Cells cellsOf(int half) const;
  template <bool perspective>
  void project(int half, std::span<const Eigen::Vector3f> points);
  void add(const SeenCell& seen);
  void updateRows(int half, std::span<const Eigen::Vector3f> masked, const DepthView* view,
                  const ModelParameters& parameters);
  std::vector<OccludedCell> occludedCells(const Cells& cells,
                                          std::span<const Eigen::Vector3f> masked,
                                          const DepthView* view,
                                          const ModelParameters& parameters) const;
  bool isOccluded(std::size_t cell, double z, const DepthView* view) const;

  GridGeometry m_geometry;
  std::vector<float> m_probabilities;
  std::vector<std::uint8_t> m_levels;
  std::vector<std::uint8_t> m_nearness;  ///< this frame: 256 - level; scratch, 0 between updates
  std::vector<SeenCell> m_strays[2];     ///< this frame, for each half of the points; scratch
  std::size_t m_frames = 0;
};

}  // namespace boomwatch
