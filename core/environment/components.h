#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "environment/environment_model.h"
#include "frame/clearance.h"

namespace boomwatch {

/// The occupied cells of a model, put together to connected pieces: what stands behind a distance
/// is not its nearest cell alone. Two of the eight neighbours belong together when their surfaces
/// differ in depth by no more than a tolerance. Where cells are smaller than 4 cm, so do those that
/// many cells apart (rounded up; R is a cell's side on the model's plane) in column and row; of a
/// column, or of a cell's own row, only the nearest is asked.
///
/// rebuild() after an update of the model; everything else is const and may be read by several
/// threads at once. 4 bytes a cell.
class Components {
 public:
  /// `tolerance` in metres; two depth levels at least, so that a slope does not fall to pieces.
  void rebuild(const EnvironmentModel& model, double tolerance);

  /// The piece of the cell that a surface point lies in (camera frame, metres), without its
  /// confidence; absent where nothing is occupied.
  std::optional<Evidence> evidenceAt(const Eigen::Vector3d& onEnvironment) const;

  /// Of which pieces the cells are not to count.
  struct Limits {
    double smallest = 0.0;  ///< metres: diagonal below which none does
    /// Metres: those with less than this diagonal, or with an area of less than a third of its
    /// square (a bird's wings are long, a person's arm is larger), count only when what is
    /// `certain` of them is itself at least the smallest thing, and half as large as the whole: a
    /// rim that comes and goes with the noise makes nothing of it doubtful, and where a slow bird
    /// was for long is little of its trail.
    double doubtful = 0.0;
    double certain = 0.0;  ///< probability of a cell
  };
  /// Indices of the cells that do not count, ascending. `model`: that of the last rebuild().
  std::vector<std::size_t> doubtful(const EnvironmentModel& model, const Limits& limits) const;

 private:
  static constexpr std::int32_t none = -1;

  void label(const EnvironmentModel& model, int tolerance);
  void measure(const EnvironmentModel& model);

  GridGeometry m_geometry;
  std::vector<std::int32_t> m_labels;  ///< row-major, a piece's index or `none`
  std::vector<Evidence> m_components;
};

/// Of a collision with the piece: see Evidence::confidence. `maxProbability`: of the update in
/// force. Pure.
double confidenceOf(const Evidence& evidence, double maxProbability);

}  // namespace boomwatch
