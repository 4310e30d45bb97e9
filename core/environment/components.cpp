#include "environment/components.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace boomwatch {
namespace {

/// Maximum distance of neighbours, in cells. Pixels are some centimetres apart on a surface.
/// Smaller cells leave empty rows between them, which must not split a trunk into several
/// components.
int reachOf(const GridGeometry& geometry) {
  constexpr double apart = 0.04;  // metres: one pixel at 10 m with a focal length of 250 pixels
  return std::max(1, static_cast<int>(std::ceil(apart / geometry.resolution() - 1e-6)));
}

/// The minimum and maximum column, row and depth level of a component.
struct Extent {
  int left = INT32_MAX, right = 0, top = INT32_MAX, bottom = 0, front = INT32_MAX, back = 0;

  void add(const GridGeometry& geometry, std::size_t cell, int level) {
    const auto columns = static_cast<std::size_t>(geometry.columns());
    const auto column = static_cast<int>(cell % columns), row = static_cast<int>(cell / columns);
    left = std::min(left, column);
    right = std::max(right, column);
    top = std::min(top, row);
    bottom = std::max(bottom, row);
    front = std::min(front, level);
    back = std::max(back, level);
  }
  /// Metres from corner to corner, where a single cell has no depth. 0 without a cell.
  double diagonal(const GridGeometry& geometry) const {
    if (back == 0) return 0.0;
    const double cell = geometry.cellSize(geometry.zOf(front));
    return Eigen::Vector3d((right - left + 1) * cell, (bottom - top + 1) * cell,
                           (back - front) * geometry.levelStep())
        .norm();
  }
};

/// Union-find over labels; a parent never comes after its children.
class Joins {
 public:
  std::int32_t add() {
    m_parent.push_back(static_cast<std::int32_t>(m_parent.size()));
    return m_parent.back();
  }
  std::int32_t join(std::int32_t a, std::int32_t b) {
    a = rootOf(a);
    b = rootOf(b);
    const std::int32_t root = std::min(a, b);
    at(a) = at(b) = root;
    return root;
  }
  /// Numbers the roots from 0. Returns the new number of each label, and the count of roots.
  std::pair<std::vector<std::int32_t>, std::size_t> numbered() {
    std::vector<std::int32_t> numbers(m_parent.size());
    std::int32_t count = 0;
    for (std::size_t k = 0; k < m_parent.size(); ++k) {
      const auto parent = static_cast<std::size_t>(m_parent[k]);
      numbers[k] = parent == k ? count++ : numbers[parent];
    }
    return {std::move(numbers), static_cast<std::size_t>(count)};
  }

 private:
  std::int32_t& at(std::int32_t label) { return m_parent[static_cast<std::size_t>(label)]; }
  std::int32_t rootOf(std::int32_t label) {
    while (at(label) != label) label = at(label) = at(at(label));
    return label;
  }

  std::vector<std::int32_t> m_parent;
};

}  // namespace

void Components::rebuild(const EnvironmentModel& model, double tolerance) {
  m_geometry = model.geometry();
  const double levels = std::floor(tolerance / m_geometry.levelStep());
  label(model, static_cast<int>(std::clamp(levels, 2.0, 255.0)));
  measure(model);
}

void Components::label(const EnvironmentModel& model, int tolerance) {
  const auto levels = model.levels();
  const int columns = m_geometry.columns(), reach = reachOf(m_geometry);
  m_labels.assign(levels.size(), none);
  Joins joins;
  // For each column, the last occupied row above this one.
  std::vector<int> last(static_cast<std::size_t>(columns), -reach - 1);
  for (int row = 0; row < m_geometry.rows(); ++row) {
    int left = -reach - 1;  // the last occupied column of this row
    for (int column = 0; column < columns; ++column) {
      const std::size_t k = m_geometry.index(column, row);
      if (levels[k] == 0) continue;
      std::int32_t label = none;
      const auto touch = [&](std::size_t other) {
        if (std::abs(levels[other] - levels[k]) > tolerance) return;
        label = label == none ? m_labels[other] : joins.join(label, m_labels[other]);
      };
      // The neighbours before this cell; it is tested again from those after it.
      if (column - left <= reach) touch(m_geometry.index(left, row));
      const int end = std::min(column + reach, columns - 1);
      for (int i = std::max(column - reach, 0); i <= end; ++i) {
        const int above = last[static_cast<std::size_t>(i)];
        if (row - above <= reach) touch(m_geometry.index(i, above));
      }
      m_labels[k] = label == none ? joins.add() : label;
      left = column;
    }
    for (int column = 0; column < columns; ++column) {
      if (levels[m_geometry.index(column, row)] != 0) last[static_cast<std::size_t>(column)] = row;
    }
  }
  const auto [numbers, count] = joins.numbered();
  for (std::int32_t& label : m_labels) {
    if (label != none) label = numbers[static_cast<std::size_t>(label)];
  }
  m_components.assign(count, {});
}

void Components::measure(const EnvironmentModel& model) {
  const int columns = m_geometry.columns(), reach = reachOf(m_geometry);
  std::vector<Extent> extents(m_components.size());
  std::vector<int> last(static_cast<std::size_t>(columns), -reach - 1);
  for (int row = 0; row < m_geometry.rows(); ++row) {
    int left = -reach - 1;
    for (int column = 0; column < columns; ++column) {
      const std::size_t k = m_geometry.index(column, row);
      if (m_labels[k] == none) continue;
      // A cell also covers the empty cells between it and the next cell of its component.
      const auto apart = [&](int cells, int otherColumn, int otherRow) {
        if (cells > reach) return 1;
        return m_labels[m_geometry.index(otherColumn, otherRow)] == m_labels[k] ? cells : 1;
      };
      int& above = last[static_cast<std::size_t>(column)];
      const int cells = apart(column - left, left, row) * apart(row - above, column, above);
      left = column;
      above = row;
      const int level = model.levels()[k];
      const auto component = static_cast<std::size_t>(m_labels[k]);
      extents[component].add(m_geometry, k, level);
      ++m_components[component].cells;
      m_components[component].probability += static_cast<double>(model.probabilities()[k]);
      const double side = m_geometry.cellSize(m_geometry.zOf(level));
      m_components[component].area += cells * side * side;
    }
  }
  for (std::size_t k = 0; k < m_components.size(); ++k) {
    m_components[k].extent = extents[k].diagonal(m_geometry);
    m_components[k].probability /= m_components[k].cells;
  }
}

std::optional<Evidence> Components::evidenceAt(const Eigen::Vector3d& onEnvironment) const {
  const Eigen::Vector2d place = m_geometry.onPlane(onEnvironment);
  const int column = m_geometry.columnOf(place.x()), row = m_geometry.rowOf(place.y());
  if (!m_geometry.contains(column, row) || m_labels.empty()) return std::nullopt;
  const std::int32_t label = m_labels[m_geometry.index(column, row)];
  if (label == none) return std::nullopt;
  return m_components[static_cast<std::size_t>(label)];
}

std::vector<std::size_t> Components::doubtful(const EnvironmentModel& model,
                                              const Limits& limits) const {
  const double minArea = limits.doubtful * limits.doubtful / 3;
  constexpr double certainPart = 0.5;  // of the diagonal of the component
  std::vector<Extent> certain(m_components.size());
  for (std::size_t k = 0; k < m_labels.size(); ++k) {
    if (m_labels[k] == none || static_cast<double>(model.probabilities()[k]) < limits.certain) {
      continue;
    }
    certain[static_cast<std::size_t>(m_labels[k])].add(m_geometry, k, model.levels()[k]);
  }
  std::vector<std::size_t> cells;
  for (std::size_t k = 0; k < m_labels.size(); ++k) {
    if (m_labels[k] == none) continue;
    const auto label = static_cast<std::size_t>(m_labels[k]);
    const Evidence& component = m_components[label];
    const bool large = component.extent >= limits.doubtful && component.area >= minArea;
    const double sure = large ? component.extent : certain[label].diagonal(m_geometry);
    if (sure == 0.0 || sure < std::max(limits.smallest, certainPart * component.extent)) {
      cells.push_back(k);
    }
  }
  return cells;
}

double confidenceOf(const Evidence& evidence, double maxProbability) {
  constexpr double side = 0.2;  // metres; a component of this size has 63 % of the confidence
  const double certain = std::clamp(evidence.probability / maxProbability, 0.0, 1.0);
  return certain * (1.0 - std::exp(-evidence.area / (side * side)));
}

}  // namespace boomwatch
