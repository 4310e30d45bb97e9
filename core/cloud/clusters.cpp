#include "cloud/clusters.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "cloud/point_grid.h"

namespace boomwatch {
namespace {

using Eigen::Vector3f;

/// Squared length in the order of operations of PCL's search tree: the last bit decides whether two
/// points at just the tolerance belong together.
float squared(const Vector3f& d) { return d.x() * d.x() + d.y() * d.y() + d.z() * d.z(); }

struct Box {
  Vector3f min;
  Vector3f max;
};

Box boxAround(std::span<const Vector3f> points) {
  Box box{points.front(), points.front()};
  for (const Vector3f& p : points) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  return box;
}

/// The halves on both sides of the middle point along the longest side of `box`.
std::array<std::span<Vector3f>, 2> halves(std::span<Vector3f> points, const Box& box) {
  int axis = 0;
  (box.max - box.min).maxCoeff(&axis);
  const std::size_t middle = points.size() / 2;
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(middle),
                   points.end(),
                   [axis](const Vector3f& a, const Vector3f& b) { return a[axis] < b[axis]; });
  return {points.first(middle), points.subspan(middle)};
}

bool anyPairBelow(std::span<const Vector3f> a, std::span<const Vector3f> b, float limit) {
  for (const Vector3f& p : a) {
    for (const Vector3f& q : b) {
      if (squared(p - q) < limit) return true;
    }
  }
  return false;
}

/// Is a point of `a` nearer to a point of `b` than the tolerance? Reorders both. Two clouds that
/// face each other at just more than the tolerance are halved until their parts are out of reach,
/// so that dense ones do not take the product of their sizes.
bool touch(std::span<Vector3f> a, std::span<Vector3f> b, float limit) {
  constexpr std::size_t fewPairs = 64;
  if (a.size() * b.size() <= fewPairs) return anyPairBelow(a, b, limit);
  if (squared(a.front() - b.front()) < limit) return true;
  const Box boxA = boxAround(a);
  const Box boxB = boxAround(b);
  // Rounding is monotonic, so these bounds hold for the rounded distances as well.
  const Vector3f gap = (boxA.min - boxB.max).cwiseMax(boxB.min - boxA.max).cwiseMax(0.0F);
  if (squared(gap) >= limit) return false;
  const Vector3f reach = (boxA.max - boxB.min).cwiseMax(boxB.max - boxA.min);
  if (squared(reach) < limit) return true;
  const bool splitA = a.size() >= b.size();
  for (const auto half : splitA ? halves(a, boxA) : halves(b, boxB)) {
    if (splitA ? touch(half, b, limit) : touch(a, half, limit)) return true;
  }
  return false;
}

/// Joins the cells of a grid that hold points nearer to each other than the tolerance. A cell is so
/// small that its own points always belong together, and what is near lies at most two cells away.
class CellJoiner {
 public:
  CellJoiner(PointGrid& grid, float limit)
      : m_grid(grid), m_limit(limit), m_parent(grid.cells.size()), m_runEnd(grid.cells.size()) {
    std::iota(m_parent.begin(), m_parent.end(), 0U);
    joinAll();
  }

  /// The same for all cells of a cluster.
  std::uint32_t rootOf(std::uint32_t cell) {
    while (m_parent[cell] != cell) cell = m_parent[cell] = m_parent[m_parent[cell]];
    return cell;
  }

 private:
  void joinAll() {
    for (const auto& row : m_grid.rows) joinWithin(row);
    flatten();
    const std::uint64_t layer = m_grid.rowsPerLayer;
    // Half of the eight rows around a row; the other half find this one.
    for (const std::uint64_t step : {std::uint64_t{1}, layer, layer - 1, layer + 1}) {
      auto other = m_grid.rows.begin();
      for (const auto& row : m_grid.rows) {
        while (other != m_grid.rows.end() && other->key < row.key + step) ++other;
        if (other == m_grid.rows.end()) break;
        if (other->key == row.key + step && !joined(row, *other)) joinRows(row, *other);
      }
      flatten();
    }
  }

  /// Lets every cell name its root, so that most pairs are told apart by one comparison, and finds
  /// the runs of cells that belong together: what is true of one of them is true of all.
  void flatten() {
    // In this order, because a parent never comes after its children.
    for (std::uint32_t& parent : m_parent) parent = m_parent[parent];
    auto end = static_cast<std::uint32_t>(m_parent.size());
    for (std::uint32_t k = end; k-- > 0;) {
      if (k + 1 < m_parent.size() && m_parent[k] != m_parent[k + 1]) end = k + 1;
      m_runEnd[k] = end;
    }
  }

  /// All of the cells of both rows, as far as parents tell.
  bool joined(const PointGrid::Row& row, const PointGrid::Row& other) const {
    const std::uint32_t parent = m_parent[row.begin];
    const auto same = [parent](std::uint32_t p) { return p == parent; };
    const auto cells = m_parent.begin();
    return m_parent[other.begin] == parent &&
           std::all_of(cells + row.begin, cells + row.end, same) &&
           std::all_of(cells + other.begin, cells + other.end, same);
  }

  void joinWithin(const PointGrid::Row& row) {
    for (std::uint32_t a = row.begin; a < row.end; ++a) {
      for (std::uint32_t b = a + 1; b < row.end && near(a, b); ++b) join(a, b);
    }
  }

  void joinRows(const PointGrid::Row& row, const PointGrid::Row& other) {
    std::uint32_t first = other.begin;
    for (std::uint32_t a = row.begin; a < row.end; ++a) {
      while (first < other.end && columnOf(first) + 2 < columnOf(a)) ++first;
      for (std::uint32_t b = first; b < other.end && near(a, b);)
        b = join(a, b) ? m_runEnd[b] : b + 1;
    }
  }

  std::uint32_t columnOf(std::uint32_t cell) const { return m_grid.cells[cell].place / 4; }
  bool near(std::uint32_t a, std::uint32_t b) const { return columnOf(b) <= columnOf(a) + 2; }

  /// Whether both now belong together.
  bool join(std::uint32_t a, std::uint32_t b) {
    if (m_parent[a] == m_parent[b]) return true;
    const std::span<Vector3f> inA = pointsOf(a);
    const std::span<Vector3f> inB = pointsOf(b);
    // Of two lone points the distance is sooner known than the roots are.
    const bool lone = inA.size() == 1 && inB.size() == 1;
    if (lone && !(squared(inA[0] - inB[0]) < m_limit)) return false;
    const std::uint32_t rootA = rootOf(a);
    const std::uint32_t rootB = rootOf(b);
    if (rootA == rootB) return true;
    if (!lone && !touch(inA, inB, m_limit)) return false;
    m_parent[std::max(rootA, rootB)] = std::min(rootA, rootB);
    return true;
  }

  std::span<Vector3f> pointsOf(std::uint32_t cell) {
    const auto& [place, begin, end] = m_grid.cells[cell];
    return std::span(m_grid.points).subspan(begin, end - begin);
  }

  PointGrid& m_grid;
  float m_limit;
  std::vector<std::uint32_t> m_parent;
  std::vector<std::uint32_t> m_runEnd;  ///< the next cell that was of another cluster
};

/// Every finite point for itself.
Clusters allApart(std::span<const Vector3f> points) {
  Clusters clusters;
  for (const Vector3f& p : points) {
    const bool measured = isMeasured(p);
    clusters.labels.push_back(measured ? static_cast<std::int32_t>(clusters.sizes.size())
                                       : Clusters::noCluster);
    if (measured) clusters.sizes.push_back(1);
  }
  return clusters;
}

/// Numbers clusters in the order in which the points first name them. `labels` holds the root cell
/// of every point, or noCluster; there are `cells` of them.
Clusters numbered(std::vector<std::int32_t> labels, std::size_t cells) {
  Clusters clusters;
  std::vector<std::int32_t> labelOfRoot(cells, Clusters::noCluster);
  for (std::int32_t& label : labels) {
    if (label == Clusters::noCluster) continue;
    std::int32_t& number = labelOfRoot[static_cast<std::size_t>(label)];
    if (number == Clusters::noCluster) {
      number = static_cast<std::int32_t>(clusters.sizes.size());
      clusters.sizes.push_back(0);
    }
    label = number;
    ++clusters.sizes[static_cast<std::size_t>(number)];
  }
  clusters.labels = std::move(labels);
  return clusters;
}

}  // namespace

Clusters euclideanClusters(std::span<const Vector3f> points, float tolerance) {
  // Squares of tolerances beyond these do not fit a float; no scene is measured in them.
  constexpr float smallest = 1e-15F;
  constexpr float largest = 1e18F;
  if (!(tolerance >= smallest)) return allApart(points);
  const double reach = std::min(tolerance, largest);
  const auto limit = static_cast<float>(reach * reach);

  // The diagonal of a cell is shorter than the tolerance by more than rounding can make up for.
  PointGrid grid = sortIntoCells(points, reach / (std::sqrt(3.0) * 1.00001));
  CellJoiner joiner(grid, limit);
  std::vector<std::int32_t> rootOfPoint(points.size(), Clusters::noCluster);
  for (std::uint32_t cell = 0; cell < grid.cells.size(); ++cell) {
    const auto root = static_cast<std::int32_t>(joiner.rootOf(cell));
    for (std::uint32_t k = grid.cells[cell].begin; k < grid.cells[cell].end; ++k) {
      rootOfPoint[grid.order[k]] = root;
    }
  }
  return numbered(std::move(rootOfPoint), grid.cells.size());
}

}  // namespace boomwatch
