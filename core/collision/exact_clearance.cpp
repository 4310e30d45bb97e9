#include "collision/exact_clearance.h"

#include <cmath>
#include <limits>
#include <optional>
#include <queue>

#include "collision/depth_pyramid.h"
#include "collision/nearest_pair.h"
#include "collision/search_target.h"

namespace boomwatch {
namespace {

using Eigen::Vector3d;

struct Block {
  double bound;  // squared
  int floor, column, row;

  // The nearest first; of those that tie, as on a flat floor, the one that is closest to the cells.
  bool operator<(const Block& other) const {
    return bound != other.bound ? bound > other.bound : floor > other.floor;
  }
};

class Search {
 public:
  Search(const DepthPyramid& pyramid, const OrientedBox& box, double limit)
      : m_pyramid(pyramid), m_geometry(pyramid.geometry()), m_target(box) {
    setBest(limit * limit);
  }

  // The surface point nearest to the box; absent when none is nearer than the limit.
  std::optional<Vector3d> run() {
    const auto& floors = m_pyramid.floors();
    if (!floors.empty()) push(static_cast<int>(floors.size()) - 1, 0, 0);
    while (!m_queue.empty() && m_queue.top().bound < m_cutOff) {
      const Block block = m_queue.top();
      m_queue.pop();
      const auto& lower = floors[static_cast<std::size_t>(block.floor - 1)];
      const int columnEnd = std::min((block.column + 1) * DepthPyramid::fan, lower.columns);
      const int rowEnd = std::min((block.row + 1) * DepthPyramid::fan, lower.rows);
      for (int j = block.row * DepthPyramid::fan; j < rowEnd; ++j) {
        for (int i = block.column * DepthPyramid::fan; i < columnEnd; ++i) {
          if (block.floor == 1) {
            lookAt(i, j);
          } else {
            push(block.floor - 1, i, j);
          }
        }
      }
    }
    return m_nearest;
  }

 private:
  void push(int floor, int column, int row) {
    const auto& blocks = m_pyramid.floors()[static_cast<std::size_t>(floor)];
    const std::size_t k = blocks.index(column, row);
    if (blocks.nearest[k] == DepthPyramid::empty) return;
    // Cells that the block covers on floor 0, where the last block may not be whole.
    const int shift = floor * DepthPyramid::fanBits;
    const int lastColumn = std::min((column + 1) << shift, m_geometry.columns()) - 1;
    const int lastRow = std::min((row + 1) << shift, m_geometry.rows()) - 1;
    const int farthest = m_pyramid.isSolid() ? GridGeometry::levels : blocks.farthest[k];
    Vector3d low = m_geometry.surfacePoint(column << shift, row << shift, blocks.nearest[k] + 1);
    Vector3d high = m_geometry.surfacePoint(lastColumn, lastRow, farthest);
    if (m_geometry.isPerspective()) spread(low, high);
    const double bound = m_target.lowerBound((low + high) / 2, (high - low) / 2);
    if (bound < m_cutOff) m_queue.push({bound, floor, column, row});
  }

  // Rays spread: what is the hull of a block's ends at one depth need not be so at the other.
  void spread(Vector3d& low, Vector3d& high) const {
    const double growth = high.z() / low.z();
    const Eigen::Vector2d lowFar = low.head<2>() * growth, highNear = high.head<2>() / growth;
    low.head<2>() = low.head<2>().cwiseMin(lowFar);
    high.head<2>() = high.head<2>().cwiseMax(highNear);
  }

  void lookAt(int column, int row) {
    const auto& cells = m_pyramid.floors().front();
    const std::uint8_t stored = cells.nearest[cells.index(column, row)];
    if (stored == DepthPyramid::empty) return;
    Vector3d surface = m_geometry.surfacePoint(column, row, stored + 1);
    if (m_pyramid.isSolid()) {
      const Vector3d end = m_geometry.surfacePoint(column, row, GridGeometry::levels);
      surface = m_target.nearestOnLine(surface, end);
    }
    const double squared = m_target.distanceTo(surface);
    if (squared >= m_best) return;
    setBest(squared);
    m_nearest = surface;
  }

  // A block that promises less than this many metres is not worth opening: its bound and the best
  // so far differ by rounding only.
  static constexpr double rounding = 1e-13;

  void setBest(double squared) {
    m_best = squared;
    const double worthwhile = std::max(std::sqrt(squared) - rounding, 0.0);
    m_cutOff = worthwhile * worthwhile;
  }

  const DepthPyramid& m_pyramid;
  const GridGeometry& m_geometry;
  SearchTarget m_target;
  std::priority_queue<Block> m_queue;
  std::optional<Vector3d> m_nearest;
  double m_best = 0, m_cutOff = 0;
};

}  // namespace

struct ExactClearance::Pyramid : DepthPyramid {};

ExactClearance::ExactClearance() = default;
ExactClearance::~ExactClearance() = default;
ExactClearance::ExactClearance(ExactClearance&&) noexcept = default;
ExactClearance& ExactClearance::operator=(ExactClearance&&) noexcept = default;

void ExactClearance::rebuild(const EnvironmentModel& model, std::span<const std::size_t> without,
                             bool solid) {
  if (!m_pyramid) m_pyramid = std::make_unique<Pyramid>();
  m_pyramid->rebuild(model, without, solid);
}

Clearance ExactClearance::query(const OrientedBox& box, double range) const {
  if (!m_pyramid) return Clearance::unknown(Reason::NoModel);
  if (!isUsable(box)) return Clearance::unknown(Reason::NoLoad);
  // What lies at the range exactly is within it; the addend leaves room for rounding.
  const double limit = std::isnan(range) ? std::numeric_limits<double>::infinity() : range + 1e-9;
  if (limit < 0) return clearanceFrom({});
  const auto surface = Search(*m_pyramid, box, limit).run();
  if (!surface) return clearanceFrom({});
  const Nearest nearest =
      nearestPair(m_pyramid->geometry(), box, box.nearestTo(*surface), *surface);
  if (nearest.distance > range) return clearanceFrom({});
  return clearanceFrom(nearest);
}

}  // namespace boomwatch
