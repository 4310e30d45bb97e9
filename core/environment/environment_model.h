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

/// What is known of a cell. Three different facts: nothing, nothing there, something there.
enum class CellState { NeverObserved, ObservedFree, Occupied };

/// The 2.5-D probabilistic model of the static surroundings (docs/method.md section 6, Eq. 6, 8-11,
/// or another update of the probabilities: see updateCells).
///
/// Row-major arrays of `geometry().columns() x rows()`: a float probability and an 8-bit depth
/// level a cell, 5 bytes. A level above 0 means occupied. A probability of exactly 0 means the cell
/// was never observed, or not for so long that Eq. 8 has brought it below `observedFloor` (0.7: 19
/// frames after 2/3): what was seen once and then gives no depth any more, over-exposed or hidden,
/// is unknown, not free. Not thread-safe; copies are independent.
class EnvironmentModel {
 public:
  EnvironmentModel() : EnvironmentModel(GridGeometry{}) {}
  explicit EnvironmentModel(const GridGeometry& geometry);

  /// One frame: crops to the bounds, projects (nearest point of a cell wins), then the update.
  /// Points that are not finite or lie before zMin are ignored. A point beyond zMax but inside the
  /// bounds in x and y shows that its cell was looked through: observed, and free in this frame. In
  /// perspective so does one that lies outside the bounds in x or y.
  ///
  /// `masked` are points that were taken out as boom, tool or load. A cell that holds one and no
  /// other measurement was hidden in this frame, which is neither of Eq. 8's cases: it stays as it
  /// is, so that an obstacle is not forgotten in the moment in which the load enters it. One that
  /// lies behind the cell's surface hides nothing: that has gone. So has, with a `view`, a surface
  /// that the camera looks through; and one that was missed so often before it was hidden that it
  /// is on its way out goes on. With a `view`, a surface that was seen for long is hidden, too, by
  /// whatever stands before it on its ray from the camera.
  void update(std::span<const Eigen::Vector3f> points, const ModelParameters& parameters,
              std::span<const Eigen::Vector3f> masked = {}, const DepthView* view = nullptr);

  const GridGeometry& geometry() const { return m_geometry; }
  std::span<const float> probabilities() const { return m_probabilities; }
  std::span<const std::uint8_t> levels() const { return m_levels; }
  std::size_t frames() const { return m_frames; }  ///< updates since it was made

  CellState state(int column, int row) const { return state(m_geometry.index(column, row)); }
  CellState state(std::size_t k) const {
    if (m_levels[k] > 0) return CellState::Occupied;
    return m_probabilities[k] > 0.0F ? CellState::ObservedFree : CellState::NeverObserved;
  }

  /// For tests and for maps that come from elsewhere: sets one cell, inside the grid, outright.
  void set(int column, int row, float probability, std::uint8_t level);

 private:
  /// A stretch of cells, by index.
  struct Cells {
    std::size_t begin, end;
    bool contain(std::size_t k) const { return k >= begin && k < end; }
  };
  /// What one point says of a cell: 256 - level, or 0 when it was looked through.
  struct SeenCell {
    std::size_t index;
    std::uint8_t nearness;
  };
  struct HiddenCell {
    std::size_t index;
    float probability;
    std::uint8_t level;
  };
  // An update runs on two threads. Each projects half of the points into its own half of the rows
  // (what falls into the other is kept as strays), then, when both are done, updates its rows: no
  // cell is shared, and the result does not depend on timing.
  Cells cellsOf(int half) const;
  template <bool perspective>
  void project(int half, std::span<const Eigen::Vector3f> points);
  void see(const SeenCell& seen);
  void updateRows(int half, std::span<const Eigen::Vector3f> masked, const DepthView* view,
                  const ModelParameters& parameters);
  std::vector<HiddenCell> hiddenCells(const Cells& cells, std::span<const Eigen::Vector3f> masked,
                                      const DepthView* view,
                                      const ModelParameters& parameters) const;
  bool isHidden(std::size_t cell, double z, const DepthView* view) const;

  GridGeometry m_geometry;
  std::vector<float> m_probabilities;
  std::vector<std::uint8_t> m_levels;
  std::vector<std::uint8_t> m_nearness;  ///< this frame: 256 - level; scratch, 0 between updates
  std::vector<SeenCell> m_strays[2];     ///< this frame, of each half of the points; scratch
  std::size_t m_frames = 0;
};

}  // namespace boomwatch
