#include "collision/ray_clearance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "collision/nearest_pair.h"

namespace boomwatch {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Whole numbers first..last; none when last < first.
struct Range {
  double first, last;
  bool empty() const { return !(first <= last); }
  // For loops. What is not empty was cut to the grid, so that it fits.
  std::int64_t begin() const { return empty() ? 0 : static_cast<std::int64_t>(first); }
  std::int64_t end() const { return empty() ? 0 : static_cast<std::int64_t>(last) + 1; }
  Range meet(double low, double high) const {
    return {std::max(first, std::ceil(low)), std::min(last, std::floor(high))};
  }
};

// Steps n = 0, 1, .. with n < length, rounding aside; always the first, so that a box thinner than
// a cell is seen.
Range stepsBelow(double length) { return {0, std::max(std::ceil(length - 1e-9) - 1, 0.0)}; }

// The grid's rectangle in the model plane, to keep walks from leaving it.
class GridRectangle {
 public:
  explicit GridRectangle(const GridGeometry& g)
      : m_low(g.bounds().xMin, g.bounds().yMin),
        m_high(m_low + g.resolution() * Vector2d(g.columns(), g.rows())) {}

  // The n of `range` at which start + n step lies in the grid.
  Range alongLine(const Vector3d& start, const Vector3d& step, Range range) const {
    for (int k = 0; k < 2; ++k) {
      const double low = m_low[k] - start[k], high = m_high[k] - start[k];
      if (step[k] == 0) {
        if (low > 0 || high < 0) return {1, 0};
        continue;
      }
      range = range.meet(std::min(low / step[k], high / step[k]),
                         std::max(low / step[k], high / step[k]));
    }
    return range;
  }

  // The n of `range` from which lines start + n step + t across can meet the grid at all.
  Range acrossLines(const Vector3d& start, const Vector3d& step, const Vector3d& across,
                    Range range) const {
    const Vector2d normal(-across.y(), across.x());
    const double perStep = normal.dot(step.head<2>());
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (const double x : {m_low.x(), m_high.x()}) {
      for (const double y : {m_low.y(), m_high.y()}) {
        const double n = normal.dot(Vector2d(x, y) - start.head<2>()) / perStep;
        least = std::min(least, n);
        most = std::max(most, n);
      }
    }
    return range.meet(least, most);
  }

 private:
  Vector2d m_low, m_high;
};

// m_1..m_4 and the sides between them: Eq. 12-19. Metres.
struct Outline {
  std::array<Vector3d, 4> corner;  // m_i
  std::array<Vector3d, 4> step;    // s_i / |s_i|: one cell along the model plane
  std::array<double, 4> length;    // |s_i| in cells

  Outline(const OrientedBox& box, double resolution) {
    Eigen::Index depth = 0;
    box.rotation.row(2).cwiseAbs().maxCoeff(&depth);
    const std::array<Eigen::Index, 2> axis{(depth + 1) % 3, (depth + 2) % 3};
    const Vector3d u = box.rotation.col(axis[0]), v = box.rotation.col(axis[1]);
    const Vector3d halfU = u * box.size[axis[0]] / 2, halfV = v * box.size[axis[1]] / 2;
    corner = {box.centre - halfU - halfV, box.centre + halfU - halfV, box.centre + halfU + halfV,
              box.centre - halfU + halfV};
    const Vector3d stepU = u * resolution / u.head<2>().norm();
    const Vector3d stepV = v * resolution / v.head<2>().norm();
    step = {stepU, stepV, -stepU, -stepV};
    const double lengthU = 2 * halfU.head<2>().norm() / resolution;
    const double lengthV = 2 * halfV.head<2>().norm() / resolution;
    length = {lengthU, lengthV, lengthU, lengthV};
  }
};

// Where the line along z through (x, y) is inside the solid box.
struct Column {
  double front, back;
  bool empty() const { return !(front <= back); }
};

Column columnThrough(const OrientedBox& box, double x, double y) {
  const Vector3d from = box.rotation.transpose() * (Vector3d(x, y, 0) - box.centre);
  const Vector3d along = box.rotation.row(2).transpose();
  Column column{-HUGE_VAL, HUGE_VAL};
  for (int k = 0; k < 3; ++k) {
    const double half = box.size[k] / 2;
    if (std::abs(along[k]) < 1e-12) {
      if (std::abs(from[k]) > half) return {1, 0};
      continue;
    }
    const double a = (-half - from[k]) / along[k], b = (half - from[k]) / along[k];
    column.front = std::max(column.front, std::min(a, b));
    column.back = std::min(column.back, std::max(a, b));
  }
  return column;
}

class RaySearch {
 public:
  RaySearch(const EnvironmentModel& model, const OrientedBox& box)
      : m_model(model),
        m_geometry(model.geometry()),
        m_box(box),
        m_grid(m_geometry),
        m_outline(box, m_geometry.resolution()) {}

  // Phase 1: p_{r,s} = m_1 + r s_1/|s_1| + s s_2/|s_2| (Eq. 12-13).
  void lookBehind() {
    const auto& [corner, step, length] = m_outline;
    const Range lines = m_grid.acrossLines(corner[0], step[0], step[1], stepsBelow(length[0]));
    for (auto r = lines.begin(); r < lines.end(); ++r) {
      const Vector3d start = corner[0] + static_cast<double>(r) * step[0];
      const Range cells = m_grid.alongLine(start, step[1], stepsBelow(length[1]));
      for (auto s = cells.begin(); s < cells.end(); ++s)
        lookThrough(start + static_cast<double>(s) * step[1]);
    }
  }

  // Phase 2: rays along n_i = -s_j/|s_j|, j = i + 1, from every `interval`-th point of side i
  // (Eq. 14-16), and one from each corner along s_j/|s_j| - s_i/|s_i|, j = i - 1 (Eq. 17-19).
  void lookAround(double interval, double radius) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3d& corner = m_outline.corner[i];
      const Vector3d along = interval * m_outline.step[i];
      const Vector3d normal = -m_outline.step[(i + 1) % 4];
      const Range rays =
          m_grid.acrossLines(corner, along, normal, stepsBelow(m_outline.length[i] / interval));
      for (auto k = rays.begin(); k < rays.end(); ++k) {
        follow(corner + static_cast<double>(k) * along, normal, {0, radius});
      }
      const Vector3d outward = m_outline.step[(i + 3) % 4] - m_outline.step[i];
      const Vector3d unit = outward * m_geometry.resolution() / outward.head<2>().norm();
      follow(corner, unit, {0, radius - 1});
    }
  }

  Clearance result() && {
    Clearance clearance = clearanceFrom(m_nearest);
    clearance.rays = std::move(m_rays);
    return clearance;
  }

 private:
  void follow(const Vector3d& start, const Vector3d& step, Range range) {
    const Range cells = m_grid.alongLine(start, step, range);
    if (cells.empty()) return;
    m_rays.push_back({start + cells.first * step, start + cells.last * step});
    for (auto l = cells.begin(); l < cells.end(); ++l) {
      const auto surface = surfaceUnder(start + static_cast<double>(l) * step);
      if (!surface) continue;
      // Eq. 20-21 from the ray's own start; a tilted box may reach over the ray, though.
      consider(m_box.contains(*surface) ? *surface : start, *surface);
    }
  }

  // The column through the cell's centre, so that the line runs along z. Where the box covers only
  // a part of the cell and not its centre, the column through the point itself.
  void lookThrough(const Vector3d& point) {
    const auto surface = surfaceUnder(point);
    if (!surface) return;
    Vector3d onLoad = *surface;
    Column column = columnThrough(m_box, onLoad.x(), onLoad.y());
    if (column.empty()) {
      onLoad = point;
      column = columnThrough(m_box, onLoad.x(), onLoad.y());
    }
    if (!column.empty()) onLoad.z() = std::clamp(surface->z(), column.front, column.back);
    consider(onLoad, *surface);
  }

  std::optional<Vector3d> surfaceUnder(const Vector3d& point) const {
    const int i = m_geometry.columnOf(point.x()), j = m_geometry.rowOf(point.y());
    if (!m_geometry.contains(i, j)) return std::nullopt;
    const int level = m_model.levels()[m_geometry.index(i, j)];
    if (level == 0) return std::nullopt;
    return m_geometry.surfacePoint(i, j, level);
  }

  void consider(const Vector3d& onLoad, const Vector3d& onEnvironment) {
    const double squared = (onLoad - onEnvironment).squaredNorm();
    if (m_nearest && squared >= m_best) return;
    m_best = squared;
    m_nearest = nearestPair(m_geometry, m_box, onLoad, onEnvironment);
  }

  const EnvironmentModel& m_model;
  const GridGeometry& m_geometry;
  const OrientedBox& m_box;
  GridRectangle m_grid;
  Outline m_outline;
  double m_best = 0;  // squared
  std::optional<Nearest> m_nearest;
  std::vector<SearchRay> m_rays;
};

}  // namespace

Clearance rayClearance(const EnvironmentModel& model, const OrientedBox& box, int interval,
                       int radius) {
  if (!isUsable(box)) return Clearance::unknown(Reason::NoLoad);
  RaySearch search(model, box);
  search.lookBehind();
  search.lookAround(std::max(interval, 1), std::max(radius, 0));
  return std::move(search).result();
}

}  // namespace boomwatch
