#include "environment/environment_model.h"

#include <future>

#include "environment/cell_update.h"

namespace boomwatch {
namespace {

/// Share of probtresh. A surface below it missed at least two frames before it was occluded, so it
/// is about to leave. Keeping it would keep the remains of the load along its path.
constexpr double minKept = 0.6;

/// Share of the maximum probability: 18 frames in a row with the thesis's values. A walking person
/// is in no cell for so long, and may have left the place where he went out of sight.
constexpr double minOld = 0.998;

/// Metres. Noise of depth can put a load that enters an obstacle a little behind its surface.
constexpr double depthRoom = 0.25;

/// Runs work(0) and work(1) in parallel; rethrows their exceptions.
template <class Work>
void inHalves(const Work& work) {
  auto first = std::async(std::launch::async, [&] { work(0); });
  work(1);
  first.get();
}

}  // namespace

EnvironmentModel::EnvironmentModel(const GridGeometry& geometry)
    : m_geometry(geometry),
      m_probabilities(geometry.cellCount()),
      m_levels(geometry.cellCount()),
      m_nearness(geometry.cellCount()) {}

void EnvironmentModel::update(std::span<const Eigen::Vector3f> points,
                              const ModelParameters& parameters,
                              std::span<const Eigen::Vector3f> masked, const DepthView* view) {
  // The points of an organised cloud run from the top of the picture to the bottom, so most points
  // of a half lie in the same half of the rows.
  const std::size_t middle = points.size() / 2;
  const std::span<const Eigen::Vector3f> halves[] = {points.first(middle), points.subspan(middle)};
  inHalves([&](int half) {
    if (m_geometry.isPerspective()) {
      project<true>(half, halves[half]);
    } else {
      project<false>(half, halves[half]);
    }
  });
  inHalves([&](int half) { updateRows(half, masked, view, parameters); });
  ++m_frames;
}

EnvironmentModel::Cells EnvironmentModel::cellsOf(int half) const {
  const std::size_t middle = m_geometry.index(0, m_geometry.rows() / 2);
  return half == 0 ? Cells{0, middle} : Cells{middle, m_geometry.cellCount()};
}

void EnvironmentModel::updateRows(int half, std::span<const Eigen::Vector3f> masked,
                                  const DepthView* view, const ModelParameters& parameters) {
  for (const SeenCell& seen : m_strays[1 - half]) add(seen);
  m_strays[1 - half].clear();  // a copy of the model must not carry them
  const Cells cells = cellsOf(half);
  std::vector<OccludedCell> occluded = occludedCells(cells, masked, view, parameters);
  std::erase_if(occluded, [minimum = static_cast<float>(minKept * parameters.probtresh)](
                              const OccludedCell& cell) {
    return cell.level > 0 && cell.probability < minimum;
  });
  const std::size_t count = cells.end - cells.begin;
  updateCells(std::span(m_probabilities).subspan(cells.begin, count),
              std::span(m_levels).subspan(cells.begin, count),
              std::span(m_nearness).subspan(cells.begin, count), parameters);
  for (const OccludedCell& cell : occluded) {
    m_probabilities[cell.index] = cell.probability;
    m_levels[cell.index] = cell.level;
  }
}

std::vector<EnvironmentModel::OccludedCell> EnvironmentModel::occludedCells(
    const Cells& cells, std::span<const Eigen::Vector3f> masked, const DepthView* view,
    const ModelParameters& parameters) const {
  std::vector<OccludedCell> occluded;
  for (const Eigen::Vector3f& point : masked) {
    const auto cell = m_geometry.indexAt(point);
    if (!cell || !cells.contain(*cell) || m_nearness[*cell] != 0) continue;
    if (isOccluded(*cell, point.z(), view)) {
      occluded.push_back({*cell, m_probabilities[*cell], m_levels[*cell]});
    }
  }
  if (!view) return occluded;
  // The object that occludes a surface is seldom in the same column.
  const auto old = static_cast<float>(minOld * maxProbability(parameters));
  for (std::size_t k = cells.begin; k < cells.end; ++k) {
    if (m_levels[k] == 0 || m_nearness[k] != 0 || m_probabilities[k] < old) continue;
    if (view->hides(m_geometry.surfacePoint(k, m_levels[k]), depthRoom)) {
      occluded.push_back({k, m_probabilities[k], m_levels[k]});
    }
  }
  return occluded;
}

/// Whether a masked point at depth z occludes the cell.
bool EnvironmentModel::isOccluded(std::size_t cell, double z, const DepthView* view) const {
  if (m_levels[cell] == 0) return true;
  const Eigen::Vector3d surface = m_geometry.surfacePoint(cell, m_levels[cell]);
  if (z > surface.z() + depthRoom) return false;
  return !view || !view->looksThrough(surface, m_geometry.cellSize(surface.z()), depthRoom);
}

/// Takes half of the time of an update with small cells, so the loop holds as little as possible.
template <bool perspective>
void EnvironmentModel::project(int half, std::span<const Eigen::Vector3f> points) {
  const GridGeometry grid = m_geometry;  // a copy, which the stores below cannot change
  const Bounds bounds = grid.bounds();
  const Cells own = cellsOf(half);
  const double columns = grid.columns(), rows = grid.rows();
  const double nearest = bounds.zMin, farthest = bounds.zMax;
  std::uint8_t* const nearness = m_nearness.data();
  float* const probabilities = m_probabilities.data();
  std::vector<SeenCell>& strays = m_strays[half];
  for (const Eigen::Vector3f& point : points) {
    const double z = point.z();
    const double toPlane = perspective ? grid.toPlane(z) : 1.0;
    const double row = grid.rowPosition(point.y() * toPlane);        // Eq. (11)
    const double column = grid.columnPosition(point.x() * toPlane);  // Eq. (10)
    // Written so that a NaN fails, and before the conversion, which would overflow.
    if (!(row >= 0.0 && row < rows && column >= 0.0 && column < columns)) continue;
    const std::size_t k = grid.index(static_cast<int>(column), static_cast<int>(row));
    std::uint8_t here = 0;
    if (perspective ? bounds.contains(point) : z >= nearest && z <= farthest) {
      // Nearer is larger, so that 0 can mean "not measured" and the nearest wins by a maximum.
      here = static_cast<std::uint8_t>(256 - grid.levelOf(z));
    } else if (!(z > (perspective ? nearest : farthest) && std::isfinite(z))) {
      continue;
    }
    if (!own.contain(k)) {
      strays.push_back({k, here});
    } else if (here > 0) {
      nearness[k] = std::max(nearness[k], here);
    } else {
      probabilities[k] = std::max(probabilities[k], seenThrough);
    }
  }
}

void EnvironmentModel::add(const SeenCell& seen) {
  if (seen.nearness > 0) {
    m_nearness[seen.index] = std::max(m_nearness[seen.index], seen.nearness);
  } else {
    m_probabilities[seen.index] = std::max(m_probabilities[seen.index], seenThrough);
  }
}

void EnvironmentModel::set(int column, int row, float probability, std::uint8_t level) {
  const std::size_t k = m_geometry.index(column, row);
  m_probabilities[k] = probability;
  m_levels[k] = level;
}

}  // namespace boomwatch
