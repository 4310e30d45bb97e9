#include "environment/environment_model.h"

#include <future>

#include "environment/cell_update.h"

namespace boomwatch {
namespace {

/// Of probtresh: a surface below it was missed at least twice before it was hidden. It is on its
/// way out and goes on, or what is left of the load where it has passed would stay for good.
constexpr double waning = 0.6;

/// Of the highest probability: seen in 18 frames in a row, with the thesis's values. A person who
/// walks is in no cell for so long, and need not be where he went out of sight.
constexpr double longKnown = 0.998;

/// Metres: a load that enters an obstacle is seen a little behind its surface, with the noise of
/// depth.
constexpr double depthRoom = 0.25;

/// Runs work(0) and work(1) beside each other; throws what they throw.
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
  // What comes from an organised cloud comes from the top of the picture to its bottom, so that
  // most of a half's points lie in that half of the rows.
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
  for (const SeenCell& seen : m_strays[1 - half]) see(seen);
  m_strays[1 - half].clear();  // they must not go along when the model is copied
  const Cells cells = cellsOf(half);
  std::vector<HiddenCell> hidden = hiddenCells(cells, masked, view, parameters);
  std::erase_if(
      hidden, [least = static_cast<float>(waning * parameters.probtresh)](const HiddenCell& cell) {
        return cell.level > 0 && cell.probability < least;
      });
  const std::size_t count = cells.end - cells.begin;
  updateCells(std::span(m_probabilities).subspan(cells.begin, count),
              std::span(m_levels).subspan(cells.begin, count),
              std::span(m_nearness).subspan(cells.begin, count), parameters);
  for (const HiddenCell& cell : hidden) {
    m_probabilities[cell.index] = cell.probability;
    m_levels[cell.index] = cell.level;
  }
}

std::vector<EnvironmentModel::HiddenCell> EnvironmentModel::hiddenCells(
    const Cells& cells, std::span<const Eigen::Vector3f> masked, const DepthView* view,
    const ModelParameters& parameters) const {
  std::vector<HiddenCell> hidden;
  for (const Eigen::Vector3f& point : masked) {
    const auto cell = m_geometry.indexAt(point);
    if (!cell || !cells.contain(*cell) || m_nearness[*cell] != 0) continue;
    if (isHidden(*cell, point.z(), view)) {
      hidden.push_back({*cell, m_probabilities[*cell], m_levels[*cell]});
    }
  }
  if (!view) return hidden;
  // What hides a surface from the camera is seldom in the same column.
  const auto known = static_cast<float>(longKnown * maxProbability(parameters));
  for (std::size_t k = cells.begin; k < cells.end; ++k) {
    if (m_levels[k] == 0 || m_nearness[k] != 0 || m_probabilities[k] < known) continue;
    if (view->hides(m_geometry.surfacePoint(k, m_levels[k]), depthRoom)) {
      hidden.push_back({k, m_probabilities[k], m_levels[k]});
    }
  }
  return hidden;
}

/// By something that was taken out of the same cell at depth z.
bool EnvironmentModel::isHidden(std::size_t cell, double z, const DepthView* view) const {
  if (m_levels[cell] == 0) return true;
  const Eigen::Vector3d surface = m_geometry.surfacePoint(cell, m_levels[cell]);
  if (z > surface.z() + depthRoom) return false;
  return !view || !view->looksThrough(surface, m_geometry.cellSize(surface.z()), depthRoom);
}

/// Half of the time of an update at small cells: what is known beforehand stays out of the loop.
template <bool perspective>
void EnvironmentModel::project(int half, std::span<const Eigen::Vector3f> points) {
  const GridGeometry grid = m_geometry;  // a copy: the stores below cannot change it
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
    // Written so that a NaN fails, and that nothing is converted that does not fit.
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

void EnvironmentModel::see(const SeenCell& seen) {
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
