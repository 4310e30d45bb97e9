#include "environment/pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace boomwatch {
namespace {

/// The least and the greatest column, row and depth level of a piece.
struct Extent {
  int left = INT32_MAX, right = 0, top = INT32_MAX, bottom = 0, front = INT32_MAX, back = 0;

  void add(int column, int row, int level) {
    left = std::min(left, column);
    right = std::max(right, column);
    top = std::min(top, row);
    bottom = std::max(bottom, row);
    front = std::min(front, level);
    back = std::max(back, level);
  }
  /// Metres from corner to corner; a cell has no depth.
  double diagonal(const GridGeometry& geometry) const {
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
  /// Numbers the roots from 0; returns what each label became, and how many there are.
  std::pair<std::vector<std::int32_t>, std::size_t> numbered() {
    std::vector<std::int32_t> names(m_parent.size());
    std::int32_t count = 0;
    for (std::size_t k = 0; k < m_parent.size(); ++k) {
      const auto parent = static_cast<std::size_t>(m_parent[k]);
      names[k] = parent == k ? count++ : names[parent];
    }
    return {std::move(names), static_cast<std::size_t>(count)};
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

void Pieces::rebuild(const EnvironmentModel& model, double tolerance) {
  m_geometry = model.geometry();
  const double levels = std::floor(tolerance / m_geometry.levelStep());
  label(model, static_cast<int>(std::clamp(levels, 2.0, 255.0)));
  measure(model);
}

void Pieces::label(const EnvironmentModel& model, int tolerance) {
  const auto levels = model.levels();
  const int columns = m_geometry.columns();
  m_labels.assign(levels.size(), none);
  Joins joins;
  for (int row = 0; row < m_geometry.rows(); ++row) {
    for (int column = 0; column < columns; ++column) {
      const std::size_t k = m_geometry.index(column, row);
      if (levels[k] == 0) continue;
      std::int32_t label = none;
      const auto touch = [&](std::size_t other) {
        if (m_labels[other] == none || std::abs(levels[other] - levels[k]) > tolerance) return;
        label = label == none ? m_labels[other] : joins.join(label, m_labels[other]);
      };
      // Half of the eight neighbours; the other half find this one.
      const auto above = k - static_cast<std::size_t>(columns);
      if (column > 0) touch(k - 1);
      if (row > 0 && column > 0) touch(above - 1);
      if (row > 0) touch(above);
      if (row > 0 && column + 1 < columns) touch(above + 1);
      m_labels[k] = label == none ? joins.add() : label;
    }
  }
  const auto [names, count] = joins.numbered();
  for (std::int32_t& label : m_labels) {
    if (label != none) label = names[static_cast<std::size_t>(label)];
  }
  m_pieces.assign(count, {});
}

void Pieces::measure(const EnvironmentModel& model) {
  std::vector<Extent> extents(m_pieces.size());
  for (int row = 0; row < m_geometry.rows(); ++row) {
    for (int column = 0; column < m_geometry.columns(); ++column) {
      const std::size_t k = m_geometry.index(column, row);
      if (m_labels[k] == none) continue;
      const int level = model.levels()[k];
      const auto piece = static_cast<std::size_t>(m_labels[k]);
      extents[piece].add(column, row, level);
      ++m_pieces[piece].cells;
      m_pieces[piece].probability += static_cast<double>(model.probabilities()[k]);
      const double side = m_geometry.cellSize(m_geometry.zOf(level));
      m_pieces[piece].area += side * side;
    }
  }
  for (std::size_t k = 0; k < m_pieces.size(); ++k) {
    m_pieces[k].extent = extents[k].diagonal(m_geometry);
    m_pieces[k].probability /= m_pieces[k].cells;
  }
}

std::optional<Evidence> Pieces::evidenceAt(const Eigen::Vector3d& onEnvironment) const {
  const Eigen::Vector2d place = m_geometry.onPlane(onEnvironment);
  const int column = m_geometry.columnOf(place.x()), row = m_geometry.rowOf(place.y());
  if (!m_geometry.contains(column, row) || m_labels.empty()) return std::nullopt;
  const std::int32_t label = m_labels[m_geometry.index(column, row)];
  if (label == none) return std::nullopt;
  return m_pieces[static_cast<std::size_t>(label)];
}

std::vector<std::size_t> Pieces::doubtful(const Limits& limits) const {
  const double leastArea = limits.doubtful * limits.doubtful / 3;
  std::vector<std::size_t> cells;
  for (std::size_t k = 0; k < m_labels.size(); ++k) {
    if (m_labels[k] == none) continue;
    const Evidence& piece = m_pieces[static_cast<std::size_t>(m_labels[k])];
    const bool large = piece.extent >= limits.doubtful && piece.area >= leastArea;
    const bool certain = large || piece.probability >= limits.certain;
    if (piece.extent < limits.smallest || !certain) cells.push_back(k);
  }
  return cells;
}

double confidenceOf(const Evidence& evidence, double highestProbability) {
  constexpr double side = 0.2;  // metres: a thing as large as this counts for about two thirds
  const double certain = std::clamp(evidence.probability / highestProbability, 0.0, 1.0);
  return certain * (1.0 - std::exp(-evidence.area / (side * side)));
}

}  // namespace boomwatch
