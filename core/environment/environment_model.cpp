#include "environment/environment_model.h"

#include <future>

#include "environment/cell_update.h"

namespace boomwatch {
namespace {

/// Of probtresh: a surface below it was missed at least twice before it was hidden. It is on its
/// way out and goes on, or what is left of the load where it has passed would stay for good.
constexpr double waning = 0.6;

}  // namespace

EnvironmentModel::EnvironmentModel(const GridGeometry& geometry)
    : m_geometry(geometry),
      m_probabilities(geometry.cellCount()),
      m_levels(geometry.cellCount()),
      m_nearness(geometry.cellCount()) {}

void EnvironmentModel::update(std::span<const Eigen::Vector3f> points,
                              const ModelParameters& parameters,
                              std::span<const Eigen::Vector3f> masked, const DepthView* view) {
  // Two bands of rows that share nothing, so that the result does not depend on timing.
  const Evidence evidence{points, masked, view};
  const int middle = m_geometry.rows() / 2;
  auto upper = std::async(std::launch::async, [&] { updateRows(0, middle, evidence, parameters); });
  updateRows(middle, m_geometry.rows(), evidence, parameters);
  upper.get();
  ++m_frames;
}

void EnvironmentModel::updateRows(int begin, int end, const Evidence& evidence,
                                  const ModelParameters& parameters) {
  projectRows(begin, end, evidence.points);
  std::vector<HiddenCell> hidden = hiddenCells(begin, end, evidence);
  std::erase_if(
      hidden, [least = static_cast<float>(waning * parameters.probtresh)](const HiddenCell& cell) {
        return cell.level > 0 && cell.probability < least;
      });
  const std::size_t first = m_geometry.index(0, begin);
  const std::size_t count = m_geometry.index(0, end) - first;
  updateCells(std::span(m_probabilities).subspan(first, count),
              std::span(m_levels).subspan(first, count),
              std::span(m_nearness).subspan(first, count), parameters);
  for (const HiddenCell& cell : hidden) {
    m_probabilities[cell.index] = cell.probability;
    m_levels[cell.index] = cell.level;
  }
}

std::vector<EnvironmentModel::HiddenCell> EnvironmentModel::hiddenCells(
    int begin, int end, const Evidence& evidence) const {
  std::vector<HiddenCell> hidden;
  for (const Eigen::Vector3f& point : evidence.masked) {
    const double toPlane = m_geometry.toPlane(point.z());
    const double row = m_geometry.rowPosition(point.y() * toPlane);
    const double column = m_geometry.columnPosition(point.x() * toPlane);
    if (!(row >= begin && row < end && column >= 0.0 && column < m_geometry.columns())) continue;
    const auto i = static_cast<int>(column), j = static_cast<int>(row);
    const std::size_t k = m_geometry.index(i, j);
    if (m_nearness[k] == 0 && isHidden(i, j, point.z(), evidence.view)) {
      hidden.push_back({k, m_probabilities[k], m_levels[k]});
    }
  }
  return hidden;
}

/// By something that was taken out of the same cell at depth z.
bool EnvironmentModel::isHidden(int column, int row, double z, const DepthView* view) const {
  // A load that enters an obstacle is seen a little behind its surface, with the noise of depth.
  constexpr double room = 0.25;  // metres
  const int level = m_levels[m_geometry.index(column, row)];
  if (level == 0) return true;
  const Eigen::Vector3d surface = m_geometry.surfacePoint(column, row, level);
  if (z > surface.z() + room) return false;
  return !view || !view->looksThrough(surface, m_geometry.cellSize(surface.z()), room);
}

void EnvironmentModel::projectRows(int begin, int end, std::span<const Eigen::Vector3f> points) {
  // Copies: the stores below cannot change them, so they stay in registers.
  const GridGeometry grid = m_geometry;
  std::uint8_t* const nearness = m_nearness.data();
  float* const probabilities = m_probabilities.data();
  const double columns = grid.columns();
  const Bounds& bounds = grid.bounds();
  const bool perspective = grid.isPerspective();
  for (const Eigen::Vector3f& point : points) {
    const double toPlane = grid.toPlane(point.z());
    const double row = grid.rowPosition(point.y() * toPlane);        // Eq. (11)
    const double column = grid.columnPosition(point.x() * toPlane);  // Eq. (10)
    // Written so that a NaN fails, and that nothing is converted that does not fit.
    if (!(row >= begin && row < end && column >= 0.0 && column < columns)) continue;
    const std::size_t k = grid.index(static_cast<int>(column), static_cast<int>(row));
    const double z = point.z();
    if (perspective ? bounds.contains(point) : z >= bounds.zMin && z <= bounds.zMax) {
      // Nearer is larger, so that 0 can mean "not measured" and the nearest wins by a maximum.
      const auto here = static_cast<std::uint8_t>(256 - grid.levelOf(z));
      nearness[k] = std::max(nearness[k], here);
    } else if (z > (perspective ? bounds.zMin : bounds.zMax) && std::isfinite(z)) {
      probabilities[k] = std::max(probabilities[k], seenThrough);
    }
  }
}

void EnvironmentModel::set(int column, int row, float probability, std::uint8_t level) {
  const std::size_t k = m_geometry.index(column, row);
  m_probabilities[k] = probability;
  m_levels[k] = level;
}

}  // namespace boomwatch
