#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "environment/environment_model.h"

namespace boomwatch {

/// The nearest and the farthest depth level of every block of `fan` x `fan` cells, then of every
/// `fan` x `fan` such blocks, and so on until one block holds the whole model.
///
/// rebuild() writes; everything else is const and may be read by several threads.
class DepthPyramid {
 public:
  static constexpr int fanBits = 2;
  static constexpr int fan = 1 << fanBits;
  static constexpr std::uint8_t empty = 255;  ///< in `nearest`: nothing occupied here

  /// Row-major blocks; on floor 0 a block is a cell.
  struct Floor {
    int columns = 0;
    int rows = 0;
    /// Smallest level less one, so that "no measurement" (0) wraps to `empty` and never wins.
    std::vector<std::uint8_t> nearest;
    /// Largest level. Not kept on floor 0, where it is `nearest` plus one.
    std::vector<std::uint8_t> farthest;

    std::size_t index(int column, int row) const {
      return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
             static_cast<std::size_t>(column);
    }
  };

  /// Takes a copy of the model's levels; uses the memory of the last time again. The cells
  /// `without` count as free.
  ///
  /// `solid`: what was never seen is taken for solid. A cell that was never observed is filled from
  /// level 1 on, and every cell that is not free down to level 255.
  void rebuild(const EnvironmentModel& model, std::span<const std::size_t> without = {},
               bool solid = false);

  bool isSolid() const { return m_solid; }
  const GridGeometry& geometry() const { return m_geometry; }
  /// From the cells to a single block, at least two; none when the model has no cells.
  const std::vector<Floor>& floors() const { return m_floors; }

 private:
  GridGeometry m_geometry;
  std::vector<Floor> m_floors;
  std::vector<std::uint8_t> m_farthest;  ///< scratch: of floor 0, where that is not the model's
  bool m_solid = false;
};

}  // namespace boomwatch
