#include "cloud/point_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace boomwatch {
namespace {

constexpr std::uint32_t margin = 2;
constexpr double maxCells = 1U << 29;  ///< along an axis, so that four times as many fit 32 bits

/// Gives coordinates along one axis their cells, from `margin` up to `count - margin`.
class Axis {
 public:
  Axis(std::span<const Eigen::Vector3f> points, int axis, float low, float high, double inverse)
      : m_origin(low), m_inverse(inverse) {
    const double span = (static_cast<double>(high) - low) * inverse;
    if (span < maxCells) {
      m_count = static_cast<std::uint64_t>(span) + 2 * margin + 1;
    } else {
      shrinkGaps(points, axis);
    }
  }

  std::uint64_t count() const { return m_count; }

  std::uint32_t cellOf(float coordinate) const {
    if (m_used.empty()) {
      return static_cast<std::uint32_t>((coordinate - m_origin) * m_inverse) + margin;
    }
    const auto found =
        std::lower_bound(m_used.begin(), m_used.end(), std::floor(coordinate * m_inverse));
    return m_numbers[static_cast<std::size_t>(found - m_used.begin())];
  }

 private:
  /// For points that span more cells than a number holds: gaps wider than two cells shrink to
  /// three. Cells are counted from zero here, not from the smallest coordinate: a far outlier must
  /// not cost the others their precision.
  void shrinkGaps(std::span<const Eigen::Vector3f> points, int axis) {
    for (const auto& p : points) {
      if (isMeasured(p)) m_used.push_back(std::floor(p[axis] * m_inverse));
    }
    std::sort(m_used.begin(), m_used.end());
    m_used.erase(std::unique(m_used.begin(), m_used.end()), m_used.end());
    m_numbers.assign(m_used.size(), margin);
    for (std::size_t k = 1; k < m_used.size(); ++k) {
      const double gap = std::min(m_used[k] - m_used[k - 1], 3.0);
      m_numbers[k] = m_numbers[k - 1] + static_cast<std::uint32_t>(gap);
    }
    m_count = m_numbers.back() + margin + 1ULL;
  }

  double m_origin;
  double m_inverse;
  std::uint64_t m_count = 0;
  std::vector<double> m_used;            ///< cells that hold points, in order; empty unless shrunk
  std::vector<std::uint32_t> m_numbers;  ///< what each of them is called
};

struct Item {
  std::uint64_t row;
  std::uint32_t place;
  std::uint32_t point;
};

/// One stable counting sort after another, least significant digit first.
template <class Key>
void radixSort(std::vector<Item>& items, std::vector<Item>& scratch, std::uint64_t largest,
               const Key& key) {
  constexpr int widest = 13;  // bits of a digit whose counts still fit the first-level cache
  const int bits = static_cast<int>(std::bit_width(largest));
  const int passes = (bits + widest - 1) / widest;
  for (int pass = 0; pass < passes; ++pass) {
    const int shift = pass * bits / passes;
    const int width = (pass + 1) * bits / passes - shift;
    const std::uint64_t mask = (1U << width) - 1;
    std::array<std::uint32_t, 1U << widest> begin{};
    for (const Item& item : items) ++begin[(key(item) >> shift) & mask];
    std::uint32_t sum = 0;
    for (std::uint32_t& slot : begin) sum += std::exchange(slot, sum);
    for (const Item& item : items) scratch[begin[(key(item) >> shift) & mask]++] = item;
    items.swap(scratch);
  }
}

std::vector<Item> sortedItems(std::span<const Eigen::Vector3f> points, double side,
                              std::uint64_t& rowsPerLayer) {
  Eigen::AlignedBox3f box;
  std::size_t measured = 0;
  for (const auto& p : points) {
    if (!isMeasured(p)) continue;
    box.extend(p);
    ++measured;
  }
  std::vector<Item> items;
  if (measured == 0) return items;
  items.reserve(measured);
  const double inverse = 1.0 / side;
  const Axis x(points, 0, box.min().x(), box.max().x(), inverse);
  const Axis y(points, 1, box.min().y(), box.max().y(), inverse);
  const Axis z(points, 2, box.min().z(), box.max().z(), inverse);
  rowsPerLayer = y.count() / 2 + 1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isMeasured(points[i])) continue;
    const std::uint32_t column = x.cellOf(points[i].x());
    const std::uint32_t line = y.cellOf(points[i].y());
    const std::uint32_t layer = z.cellOf(points[i].z());
    items.push_back({layer / 2 * rowsPerLayer + line / 2, 4 * column + 2 * (layer % 2) + line % 2,
                     static_cast<std::uint32_t>(i)});
  }
  std::vector<Item> scratch(items.size());
  radixSort(items, scratch, 4 * x.count(), [](const Item& item) { return item.place; });
  radixSort(items, scratch, z.count() * rowsPerLayer, [](const Item& item) { return item.row; });
  return items;
}

}  // namespace

PointGrid sortIntoCells(std::span<const Eigen::Vector3f> points, double side) {
  PointGrid grid;
  const std::vector<Item> items = sortedItems(points, side, grid.rowsPerLayer);
  grid.points.resize(items.size());
  grid.order.resize(items.size());
  for (std::uint32_t k = 0; k < items.size(); ++k) {
    const Item& item = items[k];
    grid.points[k] = points[item.point];
    grid.order[k] = item.point;
    const bool newRow = grid.rows.empty() || grid.rows.back().key != item.row;
    const auto cell = static_cast<std::uint32_t>(grid.cells.size());
    if (newRow) grid.rows.push_back({item.row, cell, cell});
    if (newRow || grid.cells.back().place != item.place) {
      grid.cells.push_back({item.place, k, k});
      grid.rows.back().end = cell + 1;
    }
    grid.cells.back().end = k + 1;
  }
  return grid;
}

}  // namespace boomwatch
