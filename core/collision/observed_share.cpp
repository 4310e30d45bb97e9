#include "collision/observed_share.h"

#include <algorithm>
#include <cmath>

#include "collision/footprint.h"
#include "collision/nearest_pair.h"

namespace boomwatch {
namespace {

// Columns, or rows, whose centre lies between two coordinates. Doubles: they may lie far outside.
struct Span {
  double first, last;
  Span(double low, double high, double origin, double resolution)
      : first(std::ceil((low - origin) / resolution - 0.5)),
        last(std::floor((high - origin) / resolution - 0.5)) {}
  double count() const { return std::max(last - first + 1, 0.0); }
};

class Count {
 public:
  Count(const GridGeometry& geometry, const std::vector<std::uint8_t>& seenTo,
        std::uint8_t boxLevel, const Footprint& footprint)
      : m_geometry(geometry), m_seenTo(seenTo), m_boxLevel(boxLevel), m_footprint(footprint) {}

  // Absent when no cell's centre lies within the footprint.
  std::optional<double> share() {
    const auto [low, high] = m_footprint.rows();
    const Span rows(low, high, m_geometry.plane().top, m_geometry.resolution());
    const double end = m_geometry.rows();
    countOutside(rows.first, std::min(rows.last, -1.0));
    const int first = static_cast<int>(std::clamp(rows.first, 0.0, end));
    const int last = static_cast<int>(std::clamp(rows.last, -1.0, end - 1));
    for (int j = first; j <= last; ++j) countRow(j);
    countOutside(std::max(rows.first, end), rows.last);
    if (m_all == 0) return std::nullopt;
    return m_seen / m_all;
  }

 private:
  std::optional<Span> columnsOf(double row) const {
    const double y = m_geometry.plane().top + (row + 0.5) * m_geometry.resolution();
    const auto x = m_footprint.at(y);
    if (!x) return std::nullopt;
    return Span(x->low, x->high, m_geometry.plane().left, m_geometry.resolution());
  }

  void countRow(int row) {
    const auto columns = columnsOf(row);
    if (!columns) return;
    m_all += columns->count();
    const double first = std::max(columns->first, 0.0);
    const double last = std::min(columns->last, m_geometry.columns() - 1.0);
    if (first > last) return;
    const auto begin = m_seenTo.begin() +
                       static_cast<std::ptrdiff_t>(m_geometry.index(static_cast<int>(first), row));
    const auto end = begin + static_cast<std::ptrdiff_t>(last - first + 1);
    const std::uint8_t deepEnough = m_boxLevel;
    m_seen += static_cast<double>(
        std::count_if(begin, end, [=](std::uint8_t seenTo) { return seenTo >= deepEnough; }));
  }

  // Each row while they are few. Of very many, which a wide reach gives, the middle one of each
  // band: the outline bends so little within one that the total is right to a millionth.
  void countOutside(double first, double last) {
    constexpr int bands = 4096;
    const double rows = last - first + 1;
    const double height = std::ceil(std::max(rows / bands, 1.0));
    for (int k = 0; k < bands && k * height < rows; ++k) {
      const double thickness = std::min(height, rows - k * height);
      const auto columns = columnsOf(first + k * height + (thickness - 1) / 2);
      if (columns) m_all += columns->count() * thickness;
    }
  }

  const GridGeometry& m_geometry;
  const std::vector<std::uint8_t>& m_seenTo;
  std::uint8_t m_boxLevel;  // of the box's point nearest to the camera
  const Footprint& m_footprint;
  double m_all = 0;
  double m_seen = 0;
};

}  // namespace

void ObservedShare::rebuild(const EnvironmentModel& model) {
  m_geometry = model.geometry();
  const auto probabilities = model.probabilities();
  const auto levels = model.levels();
  m_seenTo.resize(levels.size());
  for (std::size_t k = 0; k < levels.size(); ++k) {
    const std::uint8_t free = probabilities[k] > 0.0F ? GridGeometry::levels : 0;
    m_seenTo[k] = levels[k] > 0 ? levels[k] : free;
  }
}

double ObservedShare::query(const OrientedBox& box, double reach) const {
  if (m_seenTo.empty() || !isUsable(box) || !std::isfinite(reach)) return 0;
  double nearestZ = m_geometry.bounds().zMax;
  for (const auto& corner : box.corners()) nearestZ = std::min(nearestZ, corner.z());
  const std::uint8_t boxLevel = m_geometry.levelOf(nearestZ);
  if (m_geometry.isPerspective() && !(nearestZ > m_geometry.bounds().zMin)) return 0;
  std::vector<Eigen::Vector2d> outline;
  for (const auto& corner : box.corners()) outline.push_back(m_geometry.onPlane(corner));
  // A ray that comes within the reach of the box comes as near on the plane as where it is nearest.
  const double onPlane = std::max(reach, 0.0) * m_geometry.toPlane(nearestZ);
  const Footprint footprint(std::move(outline), onPlane);
  const auto share = Count(m_geometry, m_seenTo, boxLevel, footprint).share();
  if (share) return *share;
  const Eigen::Vector2d centre = m_geometry.onPlane(box.centre);
  const int column = m_geometry.columnOf(centre.x()), row = m_geometry.rowOf(centre.y());
  if (!m_geometry.contains(column, row)) return 0;
  return m_seenTo[m_geometry.index(column, row)] >= boxLevel;
}

double watchedDepth(const OrientedBox& box, double reach, const Bounds& bounds) {
  if (!isUsable(box) || !std::isfinite(reach)) return 0;
  const double half = box.rotation.row(2).cwiseAbs().dot(box.size) / 2;
  const double front = box.centre.z() - half, back = box.centre.z() + half;
  const auto watched = [](double room, double wanted) {
    if (room < 0) return 0.0;
    return room >= wanted ? 1.0 : room / wanted;
  };
  const double toCamera = std::max(front - std::min(bounds.zMin, 0.0), 0.0);
  return std::min(watched(front - bounds.zMin, std::min(reach, toCamera)),
                  watched(bounds.zMax - back, reach));
}

}  // namespace boomwatch
