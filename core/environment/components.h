#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "environment/environment_model.h"
#include "frame/clearance.h"

namespace boomwatch {

/// The connected components of the occupied cells of a model. They tell how large the object is
/// that the nearest cell belongs to.
///
/// Two cells are connected when they are 8-neighbours and their depths differ by no more than a
/// tolerance. Neighbours may lie up to 4 cm apart, rounded up to whole cells of the model's plane,
/// because small cells leave empty rows between them. Of such neighbours only the nearest one of
/// each column, and of the cell's own row, is tested.
///
/// Call rebuild() after each update of the model. All other functions are const and may be called
/// by several threads at once. 4 bytes a cell.
class Components {
 public:
  /// `tolerance`: metres; at least two depth levels, so that a slope stays one component.
  void rebuild(const EnvironmentModel& model, double tolerance);

  /// The component at a surface point (camera frame, metres), without its confidence. Absent where
  /// no cell is occupied.
  std::optional<Evidence> evidenceAt(const Eigen::Vector3d& onEnvironment) const;

  /// Which components are ignored.
  struct Limits {
    double smallest = 0.0;  ///< metres: minimum diagonal of a component
    /// Metres. A component is doubtful when its diagonal is smaller than this, or its area smaller
    /// than a third of the square of this. The area excludes a bird, whose wings are long and thin.
    /// A doubtful component counts only if its certain cells span at least `smallest`, and half of
    /// the component. So a rim that flickers with noise does no harm, and the trail of a slow bird
    /// stays ignored.
    double doubtful = 0.0;
    double certain = 0.0;  ///< minimum probability of a certain cell
  };
  /// Indices of the ignored cells, ascending. `model`: that of the last rebuild().
  std::vector<std::size_t> doubtful(const EnvironmentModel& model, const Limits& limits) const;

 private:
  static constexpr std::int32_t none = -1;

  void label(const EnvironmentModel& model, int tolerance);
  void measure(const EnvironmentModel& model);

  GridGeometry m_geometry;
  std::vector<std::int32_t> m_labels;  ///< row-major; index of the component, or `none`
  std::vector<Evidence> m_components;
};

/// Confidence of a collision with a component, 0..1; see Evidence::confidence. `maxProbability`: of
/// the current update rule. Pure.
double confidenceOf(const Evidence& evidence, double maxProbability);

}  // namespace boomwatch
