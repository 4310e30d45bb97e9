#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace boomwatch {

/// The yard's uneven ground: triangles over a square grid. Yard frame: as the camera's, but level
/// (y straight down); metres.
class YardGround {
 public:
  using Triangle = std::array<Eigen::Vector3d, 3>;

  /// `depth`: how far it is below the camera, on average.
  YardGround(std::uint64_t seed, double depth);

  /// y of the surface; beyond the grid, that of its edge.
  double yAt(double x, double z) const;
  /// Upwards, length 1.
  Eigen::Vector3d normalAt(double x, double z) const;
  /// All of them.
  std::vector<Triangle> triangles() const;
  /// Those over the rectangle given and its surroundings up to one cell away.
  std::vector<Triangle> triangles(double xMin, double xMax, double zMin, double zMax) const;

  double highest() const { return m_highest; }  ///< the least y of all

 private:
  static constexpr double cell = 0.5, left = -30.0, near = 0.0;
  static constexpr int columns = 121, rows = 91;  ///< of corners

  Eigen::Vector3d corner(int column, int row) const {
    return {left + cell * column, m_y[static_cast<std::size_t>(row * columns + column)],
            near + cell * row};
  }
  void addCell(std::vector<Triangle>& triangles, int column, int row) const;

  std::vector<double> m_y;
  double m_highest = 0.0;
};

}  // namespace boomwatch
