#include "environment/point_grid.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace boomwatch {
namespace {

constexpr std::uint32_t margin = 2;

/// The cell of every point along one axis, from `margin` up to `count - margin`.
struct AxisCells {
  std::vector<std::uint32_t> cells;
  std::uint64_t count = 0;
};

/// For points that span more cells than a number holds: gaps wider than two cells shrink to three.
/// Cells are counted from the origin, not from the smallest coordinate: a far outlier must not cost
/// the others their precision.
AxisCells numberWideAxis(const Points& points, int axis, double inverse) {
  std::vector<double> used(points.size());
  std::transform(points.begin(), points.end(), used.begin(),
                 [&](const auto& p) { return std::floor(p[axis] * inverse); });
  const std::vector<double> cells = used;
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  std::vector<std::uint32_t> numbers(used.size(), margin);
  for (std::size_t k = 1; k < used.size(); ++k) {
    numbers[k] = numbers[k - 1] + static_cast<std::uint32_t>(std::min(used[k] - used[k - 1], 3.0));
  }
  AxisCells result{std::vector<std::uint32_t>(points.size()), numbers.back() + margin + 1ULL};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto found = std::lower_bound(used.begin(), used.end(), cells[i]);
    result.cells[i] = numbers[static_cast<std::size_t>(found - used.begin())];
  }
  return result;
}

AxisCells numberAxis(const Points& points, int axis, double inverse) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
  const double origin = (*low)[axis];
  const double span = ((*high)[axis] - origin) * inverse;
  if (span >= 1U << 31) return numberWideAxis(points, axis, inverse);
  AxisCells result{std::vector<std::uint32_t>(points.size()),
                   static_cast<std::uint64_t>(span) + 2 * margin + 1};
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.cells[i] = static_cast<std::uint32_t>((points[i][axis] - origin) * inverse) + margin;
  }
  return result;
}

struct Item {
  std::uint64_t row;
  std::uint32_t x;
  std::uint32_t point;
};

/// One stable counting sort after another, least significant digit first.
template <class Key>
void radixSort(std::vector<Item>& items, std::vector<Item>& scratch, std::uint64_t largest,
               const Key& key) {
  constexpr int digit = 11;
  constexpr std::size_t values = 1U << digit;
  for (int shift = 0; shift < static_cast<int>(std::bit_width(largest)); shift += digit) {
    std::array<std::uint32_t, values> begin{};
    for (const Item& item : items) ++begin[(key(item) >> shift) % values];
    std::uint32_t sum = 0;
    for (std::uint32_t& slot : begin) sum += std::exchange(slot, sum);
    for (const Item& item : items) scratch[begin[(key(item) >> shift) % values]++] = item;
    items.swap(scratch);
  }
}

std::vector<Item> sortedItems(const Points& points, double side, std::uint64_t& rowsPerLayer) {
  const double inverse = 1.0 / side;
  const AxisCells x = numberAxis(points, 0, inverse);
  const AxisCells y = numberAxis(points, 1, inverse);
  const AxisCells z = numberAxis(points, 2, inverse);
  rowsPerLayer = y.count;
  std::vector<Item> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    items[i] = {z.cells[i] * y.count + y.cells[i], x.cells[i], static_cast<std::uint32_t>(i)};
  }
  std::vector<Item> scratch(items.size());
  radixSort(items, scratch, x.count, [](const Item& item) { return item.x; });
  radixSort(items, scratch, z.count * y.count, [](const Item& item) { return item.row; });
  return items;
}

}  // namespace

PointGrid sortIntoCells(const Points& points, double side) {
  PointGrid grid;
  if (points.empty()) return grid;
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
    if (newRow || grid.cells.back().x != item.x) {
      grid.cells.push_back({item.x, k, k});
      grid.rows.back().end = cell + 1;
    }
    grid.cells.back().end = k + 1;
  }
  return grid;
}

}  // namespace boomwatch
