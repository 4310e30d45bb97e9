#include "collision/footprint.h"

#include <algorithm>
#include <cmath>

namespace boomwatch {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Andrew's monotone chain: the lower half of the hull of points sorted by x, from end to end.
template <class Iterator>
void addHalfHull(Iterator begin, Iterator end, std::vector<Vector2d>& hull) {
  const std::size_t first = hull.size();
  for (Iterator p = begin; p != end; ++p) {
    while (hull.size() >= first + 2 &&
           cross(hull.back() - *(hull.end() - 2), *p - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(*p);
  }
  hull.pop_back();  // the other half begins with it
}

std::vector<Vector2d> seenAlongZ(const OrientedBox& box) {
  std::vector<Vector2d> points;
  for (const auto& corner : box.corners()) points.push_back(corner.head<2>());
  return points;
}

std::vector<Vector2d> hullOf(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() == 1) return points;
  std::vector<Vector2d> hull;
  addHalfHull(points.begin(), points.end(), hull);
  addHalfHull(points.rbegin(), points.rend(), hull);
  return hull;
}

}  // namespace

Footprint::Footprint(const OrientedBox& box, double reach) : Footprint(seenAlongZ(box), reach) {}
Footprint::Footprint(std::vector<Vector2d> points, double reach)
    : m_hull(hullOf(std::move(points))), m_reach(reach) {}

Footprint::Interval Footprint::rows() const {
  const auto [low, high] =
      std::minmax_element(m_hull.begin(), m_hull.end(),
                          [](const Vector2d& a, const Vector2d& b) { return a.y() < b.y(); });
  return {low->y() - m_reach, high->y() + m_reach};
}

// The outline is made of arcs around the hull's points and of its sides, moved outwards. All of
// these belong to the footprint, and its ends at this y are among them.
std::optional<Footprint::Interval> Footprint::at(double y) const {
  Interval found{HUGE_VAL, -HUGE_VAL};
  const auto add = [&](double x) { found = {std::min(found.low, x), std::max(found.high, x)}; };
  for (std::size_t k = 0; k < m_hull.size(); ++k) {
    const Vector2d& a = m_hull[k];
    const double up = y - a.y();
    if (std::abs(up) <= m_reach) {
      const double halfChord = std::sqrt((m_reach - up) * (m_reach + up));
      add(a.x() - halfChord);
      add(a.x() + halfChord);
    }
    const Vector2d side = m_hull[(k + 1) % m_hull.size()] - a;
    const double length = side.norm();
    if (length == 0) continue;
    const Vector2d start = a + Vector2d(side.y(), -side.x()) * (m_reach / length);
    const double t = (y - start.y()) / side.y();
    if (t >= 0 && t <= 1) add(start.x() + t * side.x());
  }
  if (found.low > found.high) return std::nullopt;
  return found;
}

}  // namespace boomwatch
