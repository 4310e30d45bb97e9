#include "collision/exact_clearance.h"

#include <cmath>
#include <limits>
#include <optional>
#include <queue>

#include "collision/depth_pyramid.h"
#include "collision/nearest_pair.h"

namespace boomwatch {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A box as a search needs it. Distances are squared.
class Target {
 public:
  explicit Target(const OrientedBox& box)
      : m_centre(box.centre),
        m_half(box.size / 2),
        m_outerHalf(box.rotation.cwiseAbs() * m_half),
        m_toBox(box.rotation.transpose()),
        m_toBoxExtent(m_toBox.cwiseAbs()) {}

  double distanceTo(const Vector3d& p) const {
    return ((m_toBox * (p - m_centre)).cwiseAbs() - m_half).cwiseMax(0).squaredNorm();
  }

  // Never more than the distance to any point of the block centre +- extent: the larger of two
  // gaps, that along the model's axes (the box in its hull) and that along the box's (the block in
  // its hull).
  double lowerBound(const Vector3d& centre, const Vector3d& extent) const {
    const Vector3d offset = centre - m_centre;
    const Vector3d alongModel = offset.cwiseAbs() - extent - m_outerHalf;
    const Vector3d alongBox = (m_toBox * offset).cwiseAbs() - m_toBoxExtent * extent - m_half;
    return std::max(alongModel.cwiseMax(0).squaredNorm(), alongBox.cwiseMax(0).squaredNorm());
  }

 private:
  Vector3d m_centre, m_half, m_outerHalf;
  Matrix3d m_toBox, m_toBoxExtent;
};

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
    const Vector3d low =
        m_geometry.surfacePoint(column << shift, row << shift, blocks.nearest[k] + 1);
    const Vector3d high = m_geometry.surfacePoint(lastColumn, lastRow, blocks.farthest[k]);
    const double bound = m_target.lowerBound((low + high) / 2, (high - low) / 2);
    if (bound < m_cutOff) m_queue.push({bound, floor, column, row});
  }

  void lookAt(int column, int row) {
    const auto& cells = m_pyramid.floors().front();
    const std::uint8_t stored = cells.nearest[cells.index(column, row)];
    if (stored == DepthPyramid::empty) return;
    const Vector3d surface = m_geometry.surfacePoint(column, row, stored + 1);
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
  Target m_target;
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

void ExactClearance::rebuild(const EnvironmentModel& model) {
  if (!m_pyramid) m_pyramid = std::make_unique<Pyramid>();
  m_pyramid->rebuild(model);
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
